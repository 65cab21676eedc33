#include "parallel/partition.hpp"

#include "parallel/ranks.hpp"

#ifdef TEKTITE_MPI
#include <mpi.h>
#include <zoltan.h>

#include <memory>
#endif

namespace tektite {

#ifdef TEKTITE_MPI

namespace {

using Points = std::span<const PartitionPoint>;

const Points& points_in(void* data) { return *static_cast<const Points*>(data); }

int count(void* data, int* fault) {
  *fault = ZOLTAN_OK;
  return static_cast<int>(points_in(data).size());
}

/// A particle is known by its rank and its number there.
void list(void* data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float* costs, int* fault) {
  const auto& points = points_in(data);
  for (std::size_t n = 0; n < points.size(); ++n) {
    global[2 * n] = static_cast<ZOLTAN_ID_TYPE>(rank());
    global[2 * n + 1] = local[n] = static_cast<ZOLTAN_ID_TYPE>(n);
    costs[n] = static_cast<float>(points[n].cost);
  }
  *fault = ZOLTAN_OK;
}

int dimensions(void*, int* fault) {
  *fault = ZOLTAN_OK;
  return 3;
}

void places(void* data, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int, double* x, int* fault) {
  for (int n = 0; n < count; ++n)
    for (const double coordinate : points_in(data)[local[n]].x) *x++ = coordinate;
  *fault = ZOLTAN_OK;
}

struct Destroy {
  void operator()(Zoltan_Struct* zoltan) const { Zoltan_Destroy(&zoltan); }
};

}  // namespace

std::vector<int> ranks_of(std::span<const PartitionPoint> points) {
  float version = 0.0F;
  Zoltan_Initialize(0, nullptr, &version);
  const std::unique_ptr<Zoltan_Struct, Destroy> zoltan(Zoltan_Create(MPI_COMM_WORLD));
  for (const auto& [name, value] : {std::pair{"DEBUG_LEVEL", "0"},
                                    {"LB_METHOD", "RCB"},
                                    {"NUM_GID_ENTRIES", "2"},
                                    {"OBJ_WEIGHT_DIM", "1"},
                                    {"RETURN_LISTS", "EXPORT"},
                                    {"CHECK_GEOM", "0"}})
    Zoltan_Set_Param(zoltan.get(), name, value);
  Zoltan_Set_Num_Obj_Fn(zoltan.get(), count, &points);
  Zoltan_Set_Obj_List_Fn(zoltan.get(), list, &points);
  Zoltan_Set_Num_Geom_Fn(zoltan.get(), dimensions, nullptr);
  Zoltan_Set_Geom_Multi_Fn(zoltan.get(), places, &points);

  int changes = 0, wide = 0, narrow = 0, imports = 0, exports = 0;
  int *from = nullptr, *from_parts = nullptr, *to = nullptr, *to_parts = nullptr;
  ZOLTAN_ID_PTR global_in = nullptr, local_in = nullptr, global_out = nullptr, local_out = nullptr;
  const int outcome = Zoltan_LB_Partition(zoltan.get(), &changes, &wide, &narrow, &imports, &global_in, &local_in,
                                          &from, &from_parts, &exports, &global_out, &local_out, &to, &to_parts);
  std::vector<int> owners(points.size(), rank());  // where Zoltan fails all stays where it is
  if (outcome == ZOLTAN_OK || outcome == ZOLTAN_WARN)
    for (int n = 0; n < exports; ++n) owners[local_out[n]] = to[n];
  Zoltan_LB_Free_Part(&global_in, &local_in, &from, &from_parts);
  Zoltan_LB_Free_Part(&global_out, &local_out, &to, &to_parts);
  return owners;
}

#else

std::vector<int> ranks_of(std::span<const PartitionPoint> points) { return std::vector<int>(points.size(), rank()); }

#endif

}  // namespace tektite
