// The algorithms of std::ranges that the sources use, for libc++ 13, which has none; library.h includes this.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace std::ranges {

// A predicate of values as one of elements.
template <class Test, class Projection>
auto of_element(Test& test, Projection& projection) {
    return [&](auto&& element) -> bool { return std::invoke(test, std::invoke(projection, element)); };
}
template <class Type, class Projection>
auto is_value(const Type& value, Projection& projection) {
    return [&](auto&& element) -> bool { return std::invoke(projection, element) == value; };
}
// An order of values as one of elements; {} is <.
struct Ascending {
    template <class A, class B>
    constexpr bool operator()(const A& a, const B& b) const {
        return a < b;
    }
};
template <class Order, class Projection>
auto in_order(Order& order, Projection& projection) {
    return [&](auto&& a, auto&& b) -> bool {
        return std::invoke(order, std::invoke(projection, a), std::invoke(projection, b));
    };
}

template <class Range, class Test, class Projection = identity>
bool any_of(Range&& range, Test test, Projection projection = {}) {
    return std::any_of(std::begin(range), std::end(range), of_element(test, projection));
}
template <class Range, class Test, class Projection = identity>
bool all_of(Range&& range, Test test, Projection projection = {}) {
    return std::all_of(std::begin(range), std::end(range), of_element(test, projection));
}
template <class Range, class Test, class Projection = identity>
bool none_of(Range&& range, Test test, Projection projection = {}) {
    return std::none_of(std::begin(range), std::end(range), of_element(test, projection));
}
template <class Range, class Test, class Projection = identity>
auto count_if(Range&& range, Test test, Projection projection = {}) {
    return std::count_if(std::begin(range), std::end(range), of_element(test, projection));
}
template <class Range, class Type, class Projection = identity>
auto count(Range&& range, const Type& value, Projection projection = {}) {
    return std::count_if(std::begin(range), std::end(range), is_value(value, projection));
}
template <class Range, class Test, class Projection = identity>
auto find_if(Range&& range, Test test, Projection projection = {}) {
    return std::find_if(std::begin(range), std::end(range), of_element(test, projection));
}
template <class Range, class Test, class Projection = identity>
auto find_if_not(Range&& range, Test test, Projection projection = {}) {
    return std::find_if_not(std::begin(range), std::end(range), of_element(test, projection));
}
template <class Range, class Type, class Projection = identity>
auto find(Range&& range, const Type& value, Projection projection = {}) {
    return std::find_if(std::begin(range), std::end(range), is_value(value, projection));
}
template <class Range, class Test = std::equal_to<>>
auto adjacent_find(Range&& range, Test test = {}) {
    return std::adjacent_find(std::begin(range), std::end(range), test);
}
template <class A, class B, class Test = std::equal_to<>>
bool equal(A&& a, B&& b, Test test = {}) {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b), test);
}

template <class Range, class Output>
auto copy(Range&& range, Output output) {
    return std::copy(std::begin(range), std::end(range), output);
}
template <class Range, class Output, class Test, class Projection = identity>
auto copy_if(Range&& range, Output output, Test test, Projection projection = {}) {
    return std::copy_if(std::begin(range), std::end(range), output, of_element(test, projection));
}
template <class Range, class Output>
auto move(Range&& range, Output output) {
    return std::move(std::begin(range), std::end(range), output);
}
template <class Range, class Output, class Function>
auto transform(Range&& range, Output output, Function function) {
    return std::transform(std::begin(range), std::end(range), output, function);
}
template <class Range, class Type>
void fill(Range&& range, const Type& value) {
    std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Test, class Type>
void replace_if(Range&& range, Test test, const Type& value) {
    std::replace_if(std::begin(range), std::end(range), test, value);
}
template <class Range>
void reverse(Range&& range) {
    std::reverse(std::begin(range), std::end(range));
}

template <class Range, class Order = Ascending, class Projection = identity>
void sort(Range&& range, Order order = {}, Projection projection = {}) {
    std::sort(std::begin(range), std::end(range), in_order(order, projection));
}
template <class Range, class Order = Ascending, class Projection = identity>
void stable_sort(Range&& range, Order order = {}, Projection projection = {}) {
    std::stable_sort(std::begin(range), std::end(range), in_order(order, projection));
}
template <class Range, class Iterator>
void nth_element(Range&& range, Iterator nth) {
    std::nth_element(std::begin(range), nth, std::end(range));
}
template <class Range, class Order = Ascending, class Projection = identity>
auto min_element(Range&& range, Order order = {}, Projection projection = {}) {
    return std::min_element(std::begin(range), std::end(range), in_order(order, projection));
}
template <class Range, class Order = Ascending, class Projection = identity>
auto max_element(Range&& range, Order order = {}, Projection projection = {}) {
    return std::max_element(std::begin(range), std::end(range), in_order(order, projection));
}
template <class Range>
auto min(Range&& range) {
    return *std::min_element(std::begin(range), std::end(range));
}
template <class Range>
auto max(Range&& range) {
    return *std::max_element(std::begin(range), std::end(range));
}
template <class Value>
struct min_max_result {
    Value min, max;
};
template <class Range, class Order = Ascending, class Projection = identity>
auto minmax(Range&& range, Order order = {}, Projection projection = {}) {
    const auto [least, largest] = std::minmax_element(std::begin(range), std::end(range), in_order(order, projection));
    return min_max_result<std::decay_t<decltype(*least)>>{*least, *largest};
}

}  // namespace std::ranges
