// What windows.h, Qt, sys/sysmacros.h and the AssertMacros.h of macOS define, before anything of raio.
#define near
#define far
#define small char
#define interface struct
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define emit
#define signals public
#define slots
#define foreach(variable, container) for (variable : container)
#define major(device) ((device) >> 8)
#define minor(device) ((device)&255)
#define check(assertion) static_cast<void>(assertion)
#define IN
#define OUT
#define ERROR 0
#define DELETE 65536
#define CONST const
#define PI 3.14159265358979323846
#define Success 0
#define None 0
#define Bool int
#define Status int

#include <raio/bvh/bvh.hpp>
#include <raio/raio.hpp>

// And they are what they were.
static_assert(min(1, 2) + max(3, 4) == 5 && minor(257) == 1 && major(257) == 1 && sizeof(small) == 1);
near far emit const int nothing = ERROR + None;

int main() {
    const raio::sphere<double> ball{{0, 0, 0}, 1};
    const raio::bvh<raio::sphere<double>> tree(std::vector{ball});
    raio::hit_record<double> rec;
    return tree.hit({{0, 0, 5}, {0, 0, -1}}, 0, 9, rec) && rec.t == max(4.0, 3.0) ? nothing : 1;
}
