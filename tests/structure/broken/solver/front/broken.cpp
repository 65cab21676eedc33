#include "parallel/for_each.hpp"
