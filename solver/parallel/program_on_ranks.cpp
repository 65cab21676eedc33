#include "parallel/program_on_ranks.hpp"

#include <cstdio>
#include <exception>

#include "core/error.hpp"
#include "core/program.hpp"
#include "parallel/ranks.hpp"

namespace tektite {
namespace {

int run_on_rank(const std::function<int()>& body) {
  begin_ranks();
  if (rank() == 0) return body();
  if (!std::freopen("/dev/null", "w", stdout)) throw RunError("/dev/null cannot be opened");
  try {
    return body();
  } catch (const std::exception&) {
    wait_to_be_ended();
    throw;
  }
}

}  // namespace

int run_program_on_ranks(const std::string& name, const std::function<int()>& body) {
  const int code = run_program(name, [&] { return run_on_rank(body); });
  leave_ranks(code);
  return code;
}

}  // namespace tektite
