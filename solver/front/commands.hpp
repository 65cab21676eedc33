#pragma once
// The commands of the front, each with the arguments that follow its name.

#include "core/program.hpp"
#include "front/stage.hpp"

namespace tektite::front {

/// All stages, then ours beside published.
int run(const Words& arguments);
/// Validates, explains and estimates.
int check(const Words& arguments);
/// Goes on from the newest snapshot.
int resume(const Words& arguments);
/// Runs a study and charts accuracy against cost.
int chart(const Words& arguments);
/// Maps which waves grow on lattices.
int stability(const Words& arguments);
/// Writes a page about runs.
int report(const Words& arguments);

/// Parses the arguments of a command; true where --help or --version was all that was asked.
/// Throws InputError where they are wrong.
bool parse(CommandLine& line, const Words& arguments, boost::program_options::variables_map& values);

}  // namespace tektite::front
