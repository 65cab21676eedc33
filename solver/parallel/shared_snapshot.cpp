#include "parallel/shared_snapshot.hpp"

#include <bit>
#include <string>

#include "parallel/ranks.hpp"

namespace tektite {
namespace {

void put(Words& words, double number) { words.push_back(std::bit_cast<Word>(number)); }
void put(Words& words, const std::string& text) {
  words.push_back(text.size());
  for (const char letter : text) words.push_back(static_cast<unsigned char>(letter));
}

class WordReader {
 public:
  explicit WordReader(Words words) : words_(std::move(words)) {}
  Word word() { return words_.at(next_++); }
  double number() { return std::bit_cast<double>(word()); }
  std::string text() {
    std::string text(word(), ' ');
    for (auto& letter : text) letter = static_cast<char>(word());
    return text;
  }

 private:
  Words words_;
  std::size_t next_ = 0;
};

Words words_of(const Snapshot& snapshot) {
  Words words;
  put(words, snapshot.scene);
  words.push_back(snapshot.state.size());
  for (const auto& [name, value] : snapshot.state) {
    put(words, name);
    put(words, value);
  }
  const auto& particles = snapshot.particles;
  words.push_back(static_cast<Word>(particles.space()));
  words.push_back(particles.bodies().size());
  for (const auto& body : particles.bodies()) {
    put(words, body.name);
    put(words, body.material);
    put(words, body.spacing);
  }
  for (const auto& row : field_table) words.push_back(particles.has(row.field) ? 1 : 0);
  return words;
}

Snapshot snapshot_of(Words words) {
  WordReader read(std::move(words));
  Snapshot snapshot;
  snapshot.scene = read.text();
  for (auto count = read.word(); count > 0; --count) {
    const auto name = read.text();
    snapshot.state[name] = read.number();
  }
  const auto space = static_cast<Space>(read.word());
  std::vector<Body> bodies(read.word());
  for (auto& body : bodies) {
    body.name = read.text();
    body.material = read.text();
    body.spacing = read.number();
  }
  snapshot.particles = Particles(space, std::move(bodies));
  for (const auto& row : field_table)
    if (read.word() != 0) snapshot.particles.allocate(row.field);
  return snapshot;
}

}  // namespace

void share_snapshot(Snapshot& snapshot) {
  auto words = from_first_rank(rank() == 0 ? words_of(snapshot) : Words());
  if (rank() > 0) snapshot = snapshot_of(std::move(words));
}

}  // namespace tektite
