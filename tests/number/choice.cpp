#include <raio/number/choice.hpp>

#include "support/proven.hpp"

namespace raio::test {

TEST_CASE_TEMPLATE("choice: a choice in doubt covers both, a sure one is what is chosen", W, RAIO_PRECISIONS) {
    random_numbers random(5);
    const mask_t<W> yes = W(0) == W(0), no = W(0) != W(0);
    worst first, second;
    for (int i = 0; i < share_of_lanes<W>(1000); ++i) {
        const auto a = maker<bounded_number<W>>::any(random, 10);
        const auto b = maker<rounded_number<W, 3>>::any(random, 10, &a.number.value);
        const bounded_number<W> other = b.number;
        const auto sure_a = select(verdict<mask_t<W>>{yes, yes, yes}, a.number, b.number);
        const auto sure_b = select(verdict<mask_t<W>>{no, no, no}, a.number, b.number);
        REQUIRE(all(every(sure_a.value == a.number.value, mask_t<W>(sure_a.error == a.number.error))));
        REQUIRE(all(every(sure_b.value == other.value, mask_t<W>(sure_b.error == other.error))));
        for (const mask_t<W>& answer : {yes, no}) {
            const auto either = select(verdict<mask_t<W>>{no, yes, answer}, a.number, b.number);
            REQUIRE(all(either.value == select(answer, a.number.value, other.value)));
            first.see(either, a.exact);
            second.see(either, b.exact);
        }
    }
    CHECK((first.part > 0.9 && second.part > 0.9));
}

}  // namespace raio::test
