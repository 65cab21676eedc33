#pragma once
// The loops over particles. Of the engine this room alone knows threads; the bodies are small functors with views by
// value. A body writes only to its own particle, so the answer is the same for any number of threads.

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/particles.hpp"
#include "parallel/unfused.hpp"
#include "passes/side_by_side.hpp"

namespace tektite {

/// body(i) for every i of the range, on one thread. Flattened: a body is one loop, whatever it calls.
template <class Body>
TEKTITE_UNFUSED [[gnu::flatten]] void run_through(const Range& range, const Body& body) {
  for (std::size_t i = range.begin; i < range.end; ++i) body(i);
}

/// The same with wide_pack_width particles at a time: body(SideBySide).
template <class Body>
[[gnu::flatten]] void run_side_by_side(const Range& range, const Body& body) {
  for (std::size_t i = range.begin; i < range.end; i += wide_pack_width)
    body(SideBySide{i, std::min(wide_pack_width, range.end - i)});
}

/// body(i) for every 0 ≤ i < count, each on some thread.
template <class Body>
TEKTITE_UNFUSED void for_each(std::size_t count, const Body& body) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < count; ++i) body(i);
}

/// The same where some take longer than others: a thread that is done takes the next one.
template <class Body>
void for_each_uneven(std::size_t count, const Body& body) {
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t i = 0; i < count; ++i) body(i);
}

/// The same with a room of the thread's own, which is as the thread has left it: body(i, room).
template <class Room, class Body>
void for_each_uneven(std::size_t count, std::vector<Room>& rooms, const Body& body) {
  rooms.resize(std::max(rooms.size(), static_cast<std::size_t>(omp_get_max_threads())));
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t i = 0; i < count; ++i) body(i, rooms[static_cast<std::size_t>(omp_get_thread_num())]);
}

}  // namespace tektite
