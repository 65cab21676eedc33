#pragma once
// A particle file for ParaView: one VTU, or of many particles pieces that are read, converted and written one after the
// other, so that no more of the file is in memory than a piece.

#include <string>

#include "postprocess/export/vtu.hpp"

namespace tektite {

/// Of some 300 bytes each: a piece and what is made of it take less than 0.3 GB.
inline constexpr std::size_t particles_per_piece = std::size_t{1} << 19;

/// Writes a particle file that check_file() lets pass to folder/NAME.vtu, or where it has more than `most` particles to
/// folder/NAME.pvtu, with pieces in folder/NAME/; what an older export of it has left there is removed. Gives the time
/// and the name of the file to open. Throws InputError and RunError.
TimedFile export_particles(const std::string& file, const std::string& folder, std::size_t most = particles_per_piece);

}  // namespace tektite
