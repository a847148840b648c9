// One file of a program that has two, and with ASKING the other: each is compiled with its own settings
// (settings.cmake).
#include <raio/shape/sphere.hpp>

#if defined(TREES)
#include <raio/bvh/bvh.hpp>
using shared = raio::bvh<raio::sphere<float>>;
#else
using shared = raio::sphere<float>;
#endif

std::size_t size_of(const shared* shape);

#if defined(ASKING)
int main() { return size_of(nullptr) == sizeof(shared) ? 0 : 1; }
#else
std::size_t size_of(const shared*) { return sizeof(shared); }
#endif
