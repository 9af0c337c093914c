// SPDX-License-Identifier: BSD-3-Clause
// Number output, with printf and reading back as judges.
#include "common/sexpr/writer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "common/sexpr/reader.h"

namespace k3d::sexpr {
namespace {

std::string fixed(double value, int decimals) {
    std::string out;
    append_fixed(value, decimals, out);
    return out;
}

std::string general(double value) {
    std::string out;
    append_general(value, out);
    return out;
}

std::string exact(double value) {
    std::string out;
    append_exact(value, out);
    return out;
}

std::string printed(const char* format, int decimals, double value) {
    char text[400];
    std::snprintf(text, sizeof text, format, decimals, value);
    return text;
}

TEST(SexprWriter, FixedKnownValues) {
    EXPECT_EQ(fixed(0.0, 2), "0.00");
    EXPECT_EQ(fixed(-0.0, 2), "-0.00");
    EXPECT_EQ(fixed(-0.001, 2), "-0.00");
    EXPECT_EQ(fixed(9.999, 2), "10.00");
    EXPECT_EQ(fixed(-12.345, 1), "-12.3");
    EXPECT_EQ(fixed(7.5, 0), "8");
    EXPECT_EQ(fixed(2873.8, 2), "2873.80");
    EXPECT_EQ(fixed(1e-9, 6), "0.000000");
    EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
    EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "nan");
}

TEST(SexprWriter, FixedEqualsPrintfAtTiesAndBesideThem) {
    for (int i = -20000; i <= 20000; ++i) {
        const double tie = i / 200.0;  // every second one lies on or beside x.xx5
        for (const double value : {tie, std::nextafter(tie, 1e9), std::nextafter(tie, -1e9)}) {
            ASSERT_EQ(fixed(value, 2), printed("%.*f", 2, value)) << i;
        }
    }
}

RC_GTEST_PROP(SexprWriter, FixedEqualsPrintf, ()) {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    RC_PRE(std::isfinite(value));
    const int decimals = *rc::gen::inRange(0, 7);
    RC_ASSERT(fixed(value, decimals) == printed("%.*f", decimals, value));
    const double moderate = std::remainder(value, 1e7);
    RC_ASSERT(fixed(moderate, decimals) == printed("%.*f", decimals, moderate));
}

TEST(SexprWriter, GeneralHasSixDigitsAndNoTrailingZeros) {
    EXPECT_EQ(general(30.0), "30");
    EXPECT_EQ(general(0.042), "0.042");
    EXPECT_EQ(general(-8.742278e-08), "-8.74228e-08");
    EXPECT_EQ(general(1.0), "1");
    EXPECT_EQ(general(0.0), "0");
    EXPECT_EQ(general(-0.0), "-0");
    EXPECT_EQ(general(1234567.0), "1.23457e+06");
    EXPECT_EQ(general(std::numeric_limits<double>::quiet_NaN()), "nan");
}

RC_GTEST_PROP(SexprWriter, GeneralEqualsPrintf, (double value)) {
    RC_ASSERT(general(value) == printed("%.*g", 6, value));
}

RC_GTEST_PROP(SexprWriter, ExactReadsBackAsTheSameBits, ()) {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    RC_PRE(std::isfinite(value));
    const auto read = to_number(exact(value));
    RC_ASSERT(read.has_value());
    RC_ASSERT(std::memcmp(&*read, &value, sizeof value) == 0);
}

RC_GTEST_PROP(SexprWriter, IntegersReadBack, (int value)) {
    std::string out;
    append_integer(value, out);
    RC_ASSERT(to_integer(out) == value);
}

}  // namespace
}  // namespace k3d::sexpr
