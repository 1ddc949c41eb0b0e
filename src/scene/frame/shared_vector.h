// SharedVector: a vector whose copies share its memory until one of them changes.
//
// A Frame is copied to draw it another way, and renderers keep the vertices of earlier pictures. Neither costs memory, and
// a renderer sees at once that the vertices are those it knows.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace twinlight {

template <class Value>
class SharedVector {
  public:
    using value_type = Value;
    using const_iterator = typename std::vector<Value>::const_iterator;

    SharedVector() = default;
    SharedVector(std::vector<Value> values) : values_(std::make_shared<std::vector<Value>>(std::move(values))) {}
    SharedVector(std::initializer_list<Value> values) : SharedVector(std::vector<Value>(values)) {}

    operator const std::vector<Value>&() const { return values(); }
    const_iterator begin() const { return values().begin(); }
    const_iterator end() const { return values().end(); }
    const Value* data() const { return values().data(); }
    std::size_t size() const { return values().size(); }
    bool empty() const { return values().empty(); }
    const Value& operator[](std::size_t i) const { return values()[i]; }
    const Value& at(std::size_t i) const { return values().at(i); }
    const Value& front() const { return values().front(); }
    const Value& back() const { return values().back(); }

    // To change the values of this copy only. The reference is valid until this object is copied.
    std::vector<Value>& edit() {
        if (!values_)
            values_ = std::make_shared<std::vector<Value>>();
        else if (values_.use_count() > 1)
            values_ = std::make_shared<std::vector<Value>>(*values_);
        return *values_;
    }

    // Whether both are copies of one vector, and neither has changed since; also true if both never had values.
    bool shares_memory_with(const SharedVector& other) const { return values_ == other.values_; }

    friend bool operator==(const SharedVector& a, const SharedVector& b) {
        return a.shares_memory_with(b) || a.values() == b.values();
    }

  private:
    const std::vector<Value>& values() const {
        static const std::vector<Value> none;
        return values_ ? *values_ : none;
    }

    std::shared_ptr<std::vector<Value>> values_;
};

}  // namespace twinlight
