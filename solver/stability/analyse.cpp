#include "stability/analyse.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <functional>
#include <numbers>

#include "core/stability_study.hpp"
#include "core/write_beside.hpp"
#include "parallel/for_each.hpp"
#include "parallel/threads.hpp"
#include "stability/amplification.hpp"
#include "stability/largest_step.hpp"
#include "stability/swegle.hpp"

namespace tektite {
namespace {

struct Subject {
  const StabilityLine* line;
  RunSettings settings;
  std::string material;

  int dimensions() const { return dimensions_of(settings.scene.space); }
  LatticeState state(double ratio, double stress) const {
    return {material, ratio, deformation_for(settings.materials.at(material), dimensions(), stress)};
  }
};

Subject read_subject(const StabilityLine& line) {
  auto document = Document::load(line.scene, line.variant, line.settings);
  Subject subject{&line, read_run_settings(document), line.material};
  const auto& materials = subject.settings.materials;
  if (subject.material.empty() && materials.size() == 1) subject.material = materials.begin()->first;
  if (!materials.contains(subject.material)) {
    std::vector<std::string> known;
    for (const auto& entry : materials) known.push_back(entry.first);
    throw InputError(
        {{line.scene, 0}, "material", subject.material, "the study has to name a material of this scene", join(known)});
  }
  [[maybe_unused]] const LatticeBlock tried(  // refuses what cannot be analysed
      subject.settings,
      {subject.material, 1.0, deformation_for(materials.at(subject.material), subject.dimensions(), 0.0)}, 2);
  return subject;
}

/// Rows that are worked out beside each other and stand in their order. Where one cannot be, its reason is printed and
/// `missing` stands in its place. The passes within run on one thread each.
std::string rows(std::size_t count, const std::function<std::string(std::size_t)>& row,
                 const std::function<std::string(std::size_t)>& missing) {
  std::vector<std::string> done(count), faults(count);
  for_each_uneven(count, [&](std::size_t k) {
    try {
      done[k] = row(k);
    } catch (const std::exception& fault) {
      faults[k] = fault.what();
    }
  });
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    if (!faults[k].empty()) fmt::print("  no answer for {}: {}\n", missing(k), faults[k]);
    text += (faults[k].empty() ? done[k] : missing(k)) + '\n';
  }
  return text;
}

std::string growth_rows(const Subject& subject, const StabilityStudy& study) {
  const auto columns = study.stresses.size();
  const auto where = [&](std::size_t k) {
    return fmt::format("{},{:.6g},{:.6g}", subject.line->name, study.ratios[k / columns], study.stresses[k % columns]);
  };
  return rows(
      study.ratios.size() * columns,
      [&](std::size_t k) {
        const double ratio = study.ratios[k / columns], stress = study.stresses[k % columns];
        const auto state = subject.state(ratio, stress);
        const Amplification step(subject.settings, state);
        const auto fastest = fastest_growth(step, waves_of(subject.dimensions(), study.waves));
        const double distance = state.deformation.front();
        return fmt::format("{},{:.6g},{:.6g},{:.4f},{:.4f},{}", where(k), distance, fastest.growth.rate,
                           fastest.wave[0], fastest.wave[1],
                           swegle_unstable(subject.settings.scheme.kernel, distance, ratio, stress) ? 1 : 0);
      },
      [&](std::size_t k) { return where(k) + ",nan,nan,nan,nan,nan"; });
}

std::string wave_rows(const Subject& subject, const StabilityStudy& study) {
  constexpr int directions = 18;  // steps of 5 degrees to 90
  const Amplification step(subject.settings, subject.state(study.shown_ratio, study.shown_stress));
  const bool simple = subject.settings.scheme.type != "adaptle";
  const int turns = subject.dimensions() == 1 ? 0 : directions;
  const auto angle = [](std::size_t k) { return static_cast<double>(k) * 90.0 / directions; };
  const auto lengths = 2 * static_cast<std::size_t>(study.waves);
  const auto where = [&](std::size_t k) {
    return fmt::format("{},{:.4f},{:g}", subject.line->name,
                       static_cast<double>(k % lengths + 1) / static_cast<double>(lengths), angle(k / lengths));
  };
  return rows(
      static_cast<std::size_t>(turns + 1) * lengths,
      [&](std::size_t k) {
        const double c = std::cos(angle(k / lengths) * std::numbers::pi / 180.0);
        const double s = std::sin(angle(k / lengths) * std::numbers::pi / 180.0);
        const double edge = std::numbers::pi / std::max(c, s);  // the shortest wave that the lattice tells apart
        const double length = edge * static_cast<double>(k % lengths + 1) / static_cast<double>(lengths);
        const Wave wave{length * c, length * s};
        const auto growth = step.growth(wave);
        return fmt::format("{},{:.4f},{:.6g},{:.6g},{:.6g}", where(k), length, growth.rate, growth.frequency,
                           simple ? step.strain_share(wave) : std::nan(""));
      },
      [&](std::size_t k) { return where(k) + ",nan,nan,nan,nan"; });
}

std::string step_row(const Subject& subject, const StabilityStudy& study) {
  const auto largest = largest_stable_step(subject.settings, subject.state(study.shown_ratio, 0.0), study.waves);
  const double courant = subject.settings.scheme.courant;
  fmt::print("  time step: C = {:g} in use, {:.3f} δ/c; stable up to C = {:.2f}, {:.3f} δ/c\n", courant, largest.in_use,
             courant * largest.share, largest.in_use * largest.share);
  return fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g}\n", subject.line->name, courant, largest.in_use,
                     courant * largest.share, largest.in_use * largest.share);
}

}  // namespace

void analyse_stability(const std::string& study_file, const std::string& folder, int threads) {
  use_threads(threads);
  auto document = Document::load(study_file, "", {});
  auto root = document.root();
  const auto study = read_stability_study(root);
  root.finish();
  std::vector<Subject> subjects;
  for (const auto& line : study.lines) subjects.push_back(read_subject(line));

  std::string growth = "line,ratio,stress,distance,growth,wave_x,wave_y,swegle\n";
  std::string waves = "line,part,direction,wave,growth,frequency,strain_share\n";
  std::string steps = "line,courant,step,largest_courant,largest_step\n";
  for (const auto& subject : subjects) {
    fmt::print("{}: {} in {}, {}\n", subject.line->name, subject.settings.scheme.type,
               name_of(subject.settings.scene.space), subject.settings.scheme.kernel);
    growth += growth_rows(subject, study);
    waves += wave_rows(subject, study);
    steps += step_row(subject, study);
    std::fflush(stdout);
  }
  write_text_beside(folder + "/growth.csv", growth);
  write_text_beside(folder + "/waves.csv", waves);
  write_text_beside(folder + "/steps.csv", steps);
}

}  // namespace tektite
