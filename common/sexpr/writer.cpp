// SPDX-License-Identifier: BSD-3-Clause
#include "common/sexpr/writer.h"

#include <array>
#include <charconv>
#include <cmath>

namespace k3d::sexpr {

namespace {

constexpr std::array<double, 7> kPowers{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

/// value * power, rounded to a whole number as if the product were exact, ties to even: what
/// printf does. The product of doubles may round onto a tie; only then its error is looked at.
long long rounded(double value, double power) {
    const double scaled = value * power;
    const double whole = std::nearbyint(scaled);
    const double rest = scaled - whole;
    if (rest == 0.5 || rest == -0.5) {
        const double error = std::fma(value, power, -scaled);
        if (error > 0.0) return static_cast<long long>(std::ceil(scaled));
        if (error < 0.0) return static_cast<long long>(std::floor(scaled));
    }
    return static_cast<long long>(whole);
}

}  // namespace

void append_fixed(double value, int decimals, std::string& out) {
    if (!std::isfinite(value)) {
        out += "nan";
        return;
    }
    const double power = kPowers[static_cast<std::size_t>(decimals)];
    constexpr double kExact = 4503599627370496.0;  // 2^52: below, halves are representable
    if (std::abs(value) * power >= kExact) {
        std::array<char, 340> text;  // the largest double has 309 digits before the point
        const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                       std::chars_format::fixed, decimals);
        out.append(text.data(), end.ptr);
        return;
    }
    auto digits = static_cast<unsigned long long>(rounded(std::abs(value), power));
    std::array<char, 24> text;
    char* const end = text.data() + text.size();
    char* p = end;
    for (int i = 0; i < decimals; ++i) {
        *--p = static_cast<char>('0' + digits % 10);
        digits /= 10;
    }
    if (decimals > 0) *--p = '.';
    do {
        *--p = static_cast<char>('0' + digits % 10);
        digits /= 10;
    } while (digits != 0);
    if (std::signbit(value)) *--p = '-';
    out.append(p, end);
}

void append_integer(long long value, std::string& out) {
    std::array<char, 24> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    out.append(text.data(), end.ptr);
}

void append_general(double value, std::string& out) {
    if (value == 0.0) {
        out += std::signbit(value) ? "-0" : "0";
    } else if (value == 1.0) {
        out += '1';  // rotation matrices are full of it
    } else if (!std::isfinite(value)) {
        out += "nan";
    } else {
        std::array<char, 32> text;
        const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                       std::chars_format::general, 6);
        out.append(text.data(), end.ptr);
    }
}

void append_exact(double value, std::string& out) {
    if (!std::isfinite(value)) {
        out += "nan";
        return;
    }
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    out.append(text.data(), end.ptr);
}

}  // namespace k3d::sexpr
