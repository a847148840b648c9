#include <raio/shape/heightfield.hpp>

#include "support.hpp"

namespace {

/// Every triangle, one after the other.
template <class T>
struct loop {
    static constexpr const char* name = "loop";
    using result = raio::hit_record<T>;

    raio::heightfield<T> field;

    bool operator()(const raio::ray<T>& ray, T t_min, T t_max, result& rec) const {
        bool found = false;
        for (std::size_t i = 0; i < field.size(); ++i)
            found = field[i].hit(ray, t_min, found ? rec.t : t_max, rec) || found;
        return found;
    }
};

template <class T>
void add() {
    const auto random_field = [](bench::generator& random) {
        raio::heightfield<T> field{{-1, -1}, {1, 1}, 17, {}};
        for (int i = 0; i < 17 * 17; ++i) field.heights.push_back(random.between<T>(-0.2, 0.2));
        return field;
    };
    bench::add<raio::heightfield<T>, loop<T>>("heightfield", random_field);
}

}  // namespace

int main(int argc, char** argv) {
    add<float>();
    add<double>();
    return bench::run(argc, argv);
}
