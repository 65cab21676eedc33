#include "postprocess/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <iostream>

#include "core/error.hpp"
#include "postprocess/export/fragments_csv.hpp"
#include "postprocess/export/pieces.hpp"
#include "postprocess/plan.hpp"
#include "postprocess/render/draw.hpp"
#include "postprocess/report.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

Document scene_of(const PostprocessOptions& options, const Snapshot& last, const std::string& path) {
  if (!options.scene.empty()) return Document::load(options.scene, options.variant, options.settings);
  if (!options.settings.empty()) throw InputError("--set changes a scene file; give one with --scene");
  return Document::parse(last.scene, path);
}

/// Checks each particle file but the last, which was checked for its scene, before it is read. Gives the time of each.
std::vector<double> export_snapshots(const RunFolder& run, const std::string& scene_name) {
  std::vector<TimedFile> files;
  std::vector<double> times;
  for (const auto& path : run.snapshots) {
    if (path != run.snapshots.back()) check_file(path);
    const auto [time, name] = export_particles(path, (fs::path(run.path) / "vtu").string());
    files.push_back({time, "vtu/" + name});
    times.push_back(time);
  }
  const auto collection = (fs::path(run.path) / (scene_name + ".pvd")).string();
  write_pvd(files, collection);
  std::cout << fmt::format("{} snapshots for ParaView: {}\n", files.size(), collection);
  return times;
}

/// With what the measures look at; where there is none, with what fragments need.
Event make_event(const RunFolder& run, const Plan& plan, std::vector<double> times) {
  FieldSet fields;
  for (const auto& measure : plan.measures) fields.insert(measure.measure.fields.begin(), measure.measure.fields.end());
  Event event;
  event.symmetry = plan.scene.symmetry;
  event.last = read_whole(run.snapshots.back(), event.symmetry);
  event.last_snapshot = read_fields(run.snapshots.back(), fields);
  event.fragments = find_fragments(event.last, link_of_support);
  event.history = run.history;
  event.contact_time = run.number("contact_time");
  event.snapshots = run.snapshots;
  event.times = std::move(times);
  if (plan.measures.empty()) return event;
  event.initial = read_whole(run.snapshots.front(), event.symmetry);
  event.narrow_fragments = find_fragments(event.last, link_of_smoothing_length);
  return event;
}

/// Leaves of an event what pictures look at: the last snapshot with the fields that they show, and no wholes, which
/// they make of the snapshot that they draw.
Event event_for_pictures(Event event, const std::vector<Picture>& pictures) {
  event.initial = event.last = {};
  event.fragments = event.narrow_fragments = {};
  FieldSet fields;
  for (const auto& picture : pictures) fields.merge(fields_shown(picture));
  event.last_snapshot = {};
  event.last_snapshot = read_fields(event.snapshots.back(), fields);
  return event;
}

void take_measures(const std::vector<NamedMeasure>& measures, const Event& event, Report& report) {
  for (const auto& measure : measures) try {
      report.measurements.push_back({measure.name, si_unit(measure.kind->dimension), measure.measure(event)});
    } catch (const RunError& fault) {
      report.missing.push_back(fmt::format("{}: {}", measure.name, fault.what()));
    }
}

std::string shown_by(const Picture& picture) {
  switch (picture.type) {
    case PictureType::history:
      return "history of " + join(picture.columns);
    case PictureType::profile:
      return fmt::format("profile of {} along {}", picture.field, picture.along);
    case PictureType::particles:
      break;
  }
  return picture.field + " of the particles";
}

}  // namespace

void postprocess(const PostprocessOptions& options) {
  const auto run = open_run(options.run, options.output);
  const auto& last_file = run.snapshots.back();
  check_file(last_file);
  const auto last = read_fields(last_file, {});
  auto document = scene_of(options, last, last_file);
  const auto plan = read_plan(document);

  Report report;
  report.scene = plan.scene.name;
  report.variant = options.variant.empty() ? document.variant() : options.variant;
  report.time = last.time();
  report.particles = last.particles.count();
  if (!options.reference.empty()) report.references = read_references(options.reference, report.variant, plan.measures);

  auto times = export_snapshots(run, plan.scene.name);
  auto event = make_event(run, plan, std::move(times));
  write_fragments(event.last, event.fragments, (fs::path(run.path) / "fragments.csv").string());
  take_measures(plan.measures, event, report);
  write_measurements(report, run, (fs::path(run.path) / "measurements.json").string());
  std::cout << '\n' << comparison_table(report, run) << '\n';

  if (!options.pictures) return;
  const auto pictures = plan.pictures.empty() ? default_pictures(fields_in(last_file), run.history) : plan.pictures;
  event = event_for_pictures(std::move(event), pictures);
  for (const auto& line : draw_pictures(pictures, {run, plan.scene, event, report.measurements}))
    std::cout << line << '\n';
}

void check_scene(const PostprocessOptions& options) {
  auto document = Document::load(options.scene, options.variant, options.settings);
  const auto plan = read_plan(document);
  if (!options.reference.empty()) read_references(options.reference, options.variant, plan.measures);
  for (const auto& measure : plan.measures)
    std::cout << fmt::format("measure {} in {}\n", measure.name, si_unit(measure.kind->dimension));
  for (const auto& picture : plan.pictures)
    std::cout << fmt::format("picture {}: {}, {} x {} pixels\n", picture.name, shown_by(picture), picture.width,
                             picture.height);
  if (plan.pictures.empty()) std::cout << "pictures: the usual ones\n";
}

}  // namespace tektite
