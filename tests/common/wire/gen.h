// SPDX-License-Identifier: BSD-3-Clause
// RapidCheck generators for wire messages.
#pragma once

#include <rapidcheck.h>

#include <string>

#include "common/math/geometry.h"

namespace k3d::wire {

/// A number that two decimals hold exactly.
inline rc::Gen<double> centi() {
    return rc::gen::map(rc::gen::inRange(-99999, 100000), [](int n) { return n / 100.0; });
}

inline rc::Gen<Vec3> centi_vector() {
    return rc::gen::apply([](double x, double y, double z) { return Vec3(x, y, z); }, centi(),
                          centi(), centi());
}

/// Printable bytes but blank and parentheses, at least one.
inline rc::Gen<std::string> word() {
    const auto byte = rc::gen::suchThat(rc::gen::inRange<char>(0x21, 0x7F),
                                        [](char c) { return c != '(' && c != ')'; });
    return rc::gen::nonEmpty(rc::gen::container<std::string>(byte));
}

template <class Value>
rc::Gen<std::optional<Value>> maybe(rc::Gen<Value> gen) {
    return rc::gen::map(rc::gen::maybe(std::move(gen)), [](rc::Maybe<Value> value) {
        return value ? std::optional<Value>(*value) : std::nullopt;
    });
}

}  // namespace k3d::wire
