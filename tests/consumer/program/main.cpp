#if defined(MODULE)
import raio;
#else
#include <raio/raio.hpp>
#endif

bool seen_from_the_other_file(const raio::ray<double>& ray);

int main() {
    const raio::ray<double> ray{{0, 0, 0}, {0, 0, -1}};
    const raio::sphere<double> sphere{{0, 0, -2}, 1};
    const bool seen = sphere.occluded(ray, 0, raio::infinity<double>);
    return seen && seen_from_the_other_file(ray) ? 0 : 1;
}
