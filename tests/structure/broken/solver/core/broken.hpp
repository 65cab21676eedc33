#include <CGAL/Surface_mesh.h>
#include "physics/eos/linear.hpp"
