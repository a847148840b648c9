#if !defined(__AVX2__) || !defined(__FMA__)
#error "tinybvh's BVH8_CPU needs AVX2 and FMA: compile the benchmarks with -march=native or -march=haswell"
#endif

#define TINYBVH_IMPLEMENTATION  // the library is one header
#include "peers/tinybvh.hpp"
