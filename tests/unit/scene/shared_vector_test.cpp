// SharedVector: copies share memory until one changes, and a change of one is not seen in another.
#include "scene/frame/shared_vector.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace twinlight::shared_vector_test {
namespace {

using Numbers = SharedVector<int>;

TEST(SharedVector, CopiesShareMemoryUntilOneChanges) {
    Numbers a = {1, 2, 3};
    Numbers b = a;
    EXPECT_EQ(a.data(), b.data());
    EXPECT_TRUE(a.shares_memory_with(b));
    b.edit()[1] = 7;
    EXPECT_FALSE(a.shares_memory_with(b));
    EXPECT_EQ(a, (Numbers{1, 2, 3}));
    EXPECT_EQ(b, (Numbers{1, 7, 3}));
}

TEST(SharedVector, ThatIsAloneChangesInPlace) {
    Numbers a = {1, 2, 3};
    const int* const before = a.data();
    { const Numbers copy = a; }
    a.edit()[0] = 5;
    EXPECT_EQ(a.data(), before);
}

TEST(SharedVector, WithoutValuesIsEmpty) {
    Numbers a;
    EXPECT_TRUE(a.empty());
    EXPECT_EQ(a.begin(), a.end());
    EXPECT_EQ(a, Numbers(std::vector<int>{}));
    a.edit().push_back(4);
    EXPECT_EQ(a.back(), 4);
    EXPECT_TRUE(Numbers().empty());
}

TEST(SharedVector, ThatMovesTakesTheMemoryAlong) {
    Numbers a = {1, 2};
    const int* const before = a.data();
    const Numbers b = std::move(a);
    EXPECT_EQ(b.data(), before);
}

}  // namespace
}  // namespace twinlight::shared_vector_test
