#include "parallel/shared_file.hpp"

#include "parallel/ranks.hpp"

#ifdef TEKTITE_MPI
#include <mpi.h>
#endif

namespace tektite {

#ifdef TEKTITE_MPI

namespace {

class SharedFile : public hdf5::Together {
 public:
  void open(hid_t access) const override { H5Pset_fapl_mpio(access, MPI_COMM_WORLD, MPI_INFO_NULL); }
  void transfer(hid_t properties) const override { H5Pset_dxpl_mpio(properties, H5FD_MPIO_COLLECTIVE); }
  bool first() const override { return rank() == 0; }
  bool everywhere(bool fine) const override {
    combine_over_ranks(&fine, 1, sizeof fine, [](const void* part, void* whole, std::size_t) {
      *static_cast<bool*>(whole) = *static_cast<bool*>(whole) && *static_cast<const bool*>(part);
    });
    return fine;
  }
};

}  // namespace

std::unique_ptr<hdf5::Together> file_of_all_ranks() { return std::make_unique<SharedFile>(); }

#else

std::unique_ptr<hdf5::Together> file_of_all_ranks() { return nullptr; }

#endif

}  // namespace tektite
