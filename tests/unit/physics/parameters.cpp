// Every parameter of every model: a scene that leaves its limits or gives another dimension is refused, by name.
#include <cmath>

#include "support/fault.hpp"
#include "support/models.hpp"

using namespace tektite;
using Catch::Contains;

namespace {

/// All parameters of a model as the keys of a scene, with another text for one of them; left out where it is empty.
template <class Model>
std::string parameters_with(const Model& model, std::string_view key, const std::string& text) {
  std::string keys;
  for (const auto& parameter : Model::parameters()) {
    const auto value = parameter.key == key ? text : fmt::format("{:e}", model.*parameter.member);
    if (!value.empty()) keys += fmt::format("{} = {}\n", parameter.key, value);
  }
  return keys;
}

template <class Family_, class Body>
void for_each_parameter(const Body& body) {
  test::for_each_sample<Family_>([&](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    for (const auto& parameter : Model::parameters()) {
      INFO(parameter.key);
      body(parameter, [&](const std::string& text) {
        return test::model_from<Family_, Model>(parameters_with(model, parameter.key, text));
      });
    }
  });
}

template <class Family_>
void check_limits() {
  for_each_parameter<Family_>([](const auto& parameter, const auto& read) {
    const auto& [least, most, least_excluded, most_excluded] = parameter.limits;
    CHECK(!parameter.meaning.empty());
    if (std::isfinite(least)) {
      const double below = least_excluded ? least : least - 1e-3;
      CHECK_THAT(test::fault_of([&] { read(fmt::format("{:e}", below)); }), Contains("out of range"));
    }
    if (std::isfinite(most)) {
      const double above = most_excluded ? most : most + 1e-3;
      CHECK_THAT(test::fault_of([&] { read(fmt::format("{:e}", above)); }), Contains("out of range"));
    }
    for (const std::string bad : {"nan", "inf", "'1 mol'", "true"})
      CHECK_THAT(test::fault_of([&] { read(bad); }), Contains(std::string(parameter.key)));
  });
}

/// Where one parameter has to lie above another one: below it, and at it where the model has no use for that.
template <class Family_>
void check_orders() {
  test::for_each_sample<Family_>([](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (requires { Model::ascending(); }) {
      for (const auto& pair : Model::ascending()) {
        const double lower = model.*pair.lower;
        INFO(pair.upper_key << " above " << pair.lower_key);
        const auto read = [&](double upper) {
          test::model_from<Family_, Model>(parameters_with(model, pair.upper_key, fmt::format("{:e}", upper)));
        };
        CHECK_THAT(test::fault_of([&] { read(0.5 * lower); }),
                   Contains(fmt::format("{} = {:g}", pair.lower_key, lower)) &&
                       Contains(fmt::format("{} = {}", pair.upper_key, 0.5 * lower)));
        if (pair.may_be_equal)
          CHECK_NOTHROW(read(lower));
        else
          CHECK_THAT(test::fault_of([&] { read(lower); }), Contains("out of order"));
      }
    }
  });
}

template <class Family_>
void check_dimensions() {
  for_each_parameter<Family_>([](const auto& parameter, const auto& read) {
    CHECK_THAT(test::fault_of([&] { read("'1 kg'"); }), Contains(std::string(parameter.key)) && Contains("mass"));
  });
}

template <class Family_>
void check_defaults() {
  for_each_parameter<Family_>([](const auto& parameter, const auto& read) {
    if (std::isnan(parameter.otherwise))
      CHECK_THAT(test::fault_of([&] { read(""); }), Contains("missing"));
    else
      CHECK(read("").*parameter.member == parameter.otherwise);
  });
}

template <class Family_>
void check_unknown_name() {
  auto document = Document::parse("model = 'putty'", "scene.toml");
  const auto message = test::fault_of([&] {
    auto root = document.root();
    Family<Family_>::read(root);
  });
  for (const auto& name : Family<Family_>::names()) CHECK_THAT(message, Contains(name));
}

}  // namespace

TEST_CASE("Models: a parameter outside its limits is refused", "[parameters]") {
  check_limits<Eos>();
  check_limits<Strength>();
  check_limits<Viscosity>();
  check_limits<Riemann>();
  check_limits<Limiter>();
}

TEST_CASE("Models: two parameters in the wrong order are refused, both by name and value", "[parameters]") {
  check_orders<Strength>();
  check_orders<Damage>();
}

TEST_CASE("Models: a parameter of another dimension is refused", "[parameters]") {
  check_dimensions<Eos>();
  check_dimensions<Strength>();
  check_dimensions<Viscosity>();
  check_dimensions<Riemann>();
  check_dimensions<Limiter>();
}

TEST_CASE("Models: a parameter that is left out has its declared value or is asked for", "[parameters]") {
  check_defaults<Eos>();
  check_defaults<Strength>();
  check_defaults<Viscosity>();
  check_defaults<Riemann>();
  check_defaults<Limiter>();
}

TEST_CASE("Models: an unknown name is answered with the known ones", "[parameters]") {
  check_unknown_name<Eos>();
  check_unknown_name<Strength>();
  check_unknown_name<Viscosity>();
  check_unknown_name<Riemann>();
  check_unknown_name<Limiter>();
}
