#pragma once
inline void broken() {
#pragma omp parallel
  {}
}
