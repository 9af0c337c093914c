// SPDX-License-Identifier: BSD-3-Clause
// Appends s-expression pieces to a string; fixed-point numbers without iostreams or locale.
#pragma once

#include <string>
#include <string_view>

namespace k3d::sexpr {

/// Fixed notation with `decimals` (0..6) places: the bytes of printf("%.*f"), so "-0.00" for small
/// negative values as the reference writes it. Non-finite values are written as "nan".
void append_fixed(double value, int decimals, std::string& out);

void append_integer(long long value, std::string& out);

/// Six significant digits, no trailing zeros: the default stream form used on the monitor port.
void append_general(double value, std::string& out);

/// Shortest text that reads back as the same double; may hold an exponent.
void append_exact(double value, std::string& out);

}  // namespace k3d::sexpr
