// The private X server: each picture is another client of it, and none must be turned away.

#include "postprocess/render/display.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "support/apart.hpp"

namespace tektite::test {
namespace {

/// Says good day to the server as a client of the protocol X11 does, and leaves again.
bool is_received(const std::string& display) {
  const int connection = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string path = "/tmp/.X11-unix/X" + display.substr(1);
  std::copy_n(path.begin(), std::min(path.size(), sizeof address.sun_path - 1), address.sun_path);
  bool received = connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  // Little-endian, version 11.0, no authorisation.
  const std::array<std::uint8_t, 12> request{'l', 0, 11, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  std::uint8_t answer = 0;
  received = received && send(connection, request.data(), request.size(), MSG_NOSIGNAL) == 12;
  received = received && recv(connection, &answer, 1, 0) == 1 && answer == 1;
  close(connection);
  return received;
}

}  // namespace

TEST_CASE("Private display: takes one client after the other, however soon the next one comes") {
  const PrivateDisplay display;
  const std::string name = std::getenv("DISPLAY");
  int turned_away = 0;
  for (int client = 0; client < 300; ++client) turned_away += !is_received(name);
  CHECK(turned_away == 0);
}

TEST_CASE("Private display: a server for which no pipe can be made is told with the reason") {
  const auto said = fault_apart([] {
    const rlimit no_files{STDERR_FILENO + 1, STDERR_FILENO + 1};
    setrlimit(RLIMIT_NOFILE, &no_files);
    const PrivateDisplay display;
  });
  CHECK_THAT(said, Catch::Contains("Xvfb") && Catch::Contains("Too many open files"));
}

}  // namespace tektite::test
