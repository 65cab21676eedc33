#include "postprocess/plan.hpp"

namespace tektite {

Plan read_plan(Document& document) {
  auto root = document.root();
  Plan plan;
  plan.scene = read_scene(root, Stage::postprocess);
  plan.declared.space = plan.scene.space;
  for (auto& [name, body] : root.named_sections("body")) plan.declared.bodies.push_back(name);
  for (auto& [name, probe] : root.named_sections("probe"))
    plan.declared.body_of_probe[name] = probe.choice("body", plan.declared.bodies);
  plan.measures = read_measures(root, plan.declared);
  plan.pictures = read_pictures(root, plan.declared);
  root.finish();
  return plan;
}

}  // namespace tektite
