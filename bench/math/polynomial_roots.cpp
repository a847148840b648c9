#include <raio/math/polynomial_roots.hpp>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "support.hpp"

/// \file
/// The roots of polynomials between -1 and 1, with coefficients between -1 and 1, beside the eigenvalues of the
/// companion matrix by Eigen. POLYNOMIAL/SOLVER/NUMBER/DEGREE.

namespace {

constexpr std::size_t polynomial_count = 256;

template <class T, std::size_t N>
std::vector<std::array<T, N + 1>> random_coefficients() {
    bench::generator random;
    std::vector<std::array<T, N + 1>> all(polynomial_count);
    for (auto& coefficients : all) {
        for (T& c : coefficients) c = random.between<T>(-1, 1);
    }
    return all;
}

/// Roots with their errors, and whether they are all.
struct isolated {
    static constexpr const char* name = "roots_between";

    template <class W, class T, std::size_t M>
    static std::size_t count(const std::array<T, M>& coefficients) {
        raio::polynomial<W, M - 1> p;
        for (std::size_t k = 0; k < M; ++k) p.coefficient[k] = W(coefficients[k]);
        const auto found = raio::roots_between(p, W(-1), W(1));
        benchmark::DoNotOptimize(found);
        return found.count;
    }
};

/// Every complex root, of which those count that look real.
struct companion_matrix {
    static constexpr const char* name = "eigen_companion_matrix";

    template <class, class T, std::size_t M>
    static std::size_t count(const std::array<T, M>& coefficients) {
        constexpr int degree = static_cast<int>(M) - 1;
        Eigen::Matrix<double, degree, degree> matrix = Eigen::Matrix<double, degree, degree>::Zero();
        for (int row = 1; row < degree; ++row) matrix(row, row - 1) = 1;
        for (int row = 0; row < degree; ++row) {
            matrix(row, degree - 1) = -coefficients[static_cast<std::size_t>(row)] / coefficients[M - 1];
        }
        const auto roots = matrix.eigenvalues().eval();
        benchmark::DoNotOptimize(roots);
        std::size_t real = 0;
        for (int i = 0; i < degree; ++i) {
            real += std::abs(roots[i].imag()) < 1e-10 && std::abs(roots[i].real()) <= 1;
        }
        return real;
    }
};

template <class Solver, class W, std::size_t N>
void add(const char* number) {
    const std::string name = std::string("polynomial/") + Solver::name + '/' + number + '/' + std::to_string(N);
    benchmark::RegisterBenchmark(name.c_str(), [](benchmark::State& state) {
        const auto all = random_coefficients<double, N>();
        std::size_t next = 0, roots = 0;
        for (auto _ : state) roots += Solver::template count<W>(all[next++ % polynomial_count]);
        using benchmark::Counter;
        const double solved = static_cast<double>(state.iterations());
        state.counters["test"] = Counter(solved, Counter::kIsRate | Counter::kInvert);
        state.counters["roots"] = static_cast<double>(roots) / solved;
        state.counters["record"] = 0;
    });
}

template <std::size_t N>
void add_degree() {
    add<isolated, raio::strict_double, N>("strict_double");
    add<isolated, raio::double_double, N>("double_double");
    add<companion_matrix, double, N>("double");
}

}  // namespace

int main(int argc, char** argv) {
    add_degree<2>();
    add_degree<3>();
    add_degree<4>();
    add_degree<8>();
    return bench::run(argc, argv);
}
