#pragma once
// The readers of all arrangements, each defined in the file of its name. A reader takes its own keys from the section;
// `type`, `count` and `mass` are the registry's.

#include "preprocess/arrangement/arrangement.hpp"

namespace tektite::preprocess {

ArrangementPointer read_lattice(Section& section, int dimensions);
ArrangementPointer read_rings(Section& section, int dimensions);
ArrangementPointer read_lattice_with_rings(Section& section, int dimensions);
ArrangementPointer read_shells(Section& section, int dimensions);
ArrangementPointer read_hexagonal(Section& section, int dimensions);
ArrangementPointer read_close_packed(Section& section, int dimensions);

}  // namespace tektite::preprocess
