#pragma once
// From what a scene asks for to the template that does it: the kernel by its name, the space out of those supported.

#include <type_traits>

#include "schemes/scheme.hpp"

namespace tektite {

/// make(kernel) with the type_identity of the kernel of this name; every kernel of the family is known.
template <class Make>
std::unique_ptr<Scheme> with_kernel(const std::string& name, const Make& make) {
  std::unique_ptr<Scheme> scheme;
  [&]<class... Kernels>(std::type_identity<std::variant<Kernels...>>) {
    ((Kernels::name == name ? void(scheme = make(std::type_identity<Kernels>{})) : void()), ...);
  }(std::type_identity<Kernel>{});
  return scheme;
}

/// make(space) with the scene's space as a constant, out of `spaces`. Throws InputError, which names them, where it is
/// none of these.
template <Space... spaces, class Make>
std::unique_ptr<Scheme> in_space(const SchemeSetup& setup, const Make& make) {
  const Space asked = setup.particles.space();
  std::unique_ptr<Scheme> scheme;
  ((asked == spaces ? void(scheme = make(std::integral_constant<Space, spaces>{})) : void()), ...);
  if (scheme) return scheme;
  const std::vector<std::string> allowed{std::string(name_of(spaces))...};
  throw InputError({{},
                    "space",
                    std::string(name_of(asked)),
                    "the scheme " + setup.settings.type + " does not support it",
                    join(allowed)});
}

}  // namespace tektite
