// SPDX-License-Identifier: BSD-3-Clause
// Codes a team message into 20 printable bytes: a tag, 17 symbols of 6 bits, a two-symbol check.
#include "agent/talk/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace k3d::agent::talk {
namespace {

// 64 bytes without blank, parentheses, quotes, backslash and semicolon: those have a meaning in
// the reference server's reader (reference 1.4).
constexpr std::string_view kAlphabet =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz+-";
static_assert(kAlphabet.size() == 64);
constexpr char kTag = 'k';  // tells our messages from those of other programs
constexpr std::size_t kDataSymbols = 17;
constexpr std::size_t kCheckSymbols = 2;
static_assert(1 + kDataSymbols + kCheckSymbols == kMessageBytes);

// Quantities: field plus one metre around it in 2047 levels (x to 16 mm, y to 11 mm), speeds to
// 0.05 m/s. Odd numbers of levels, so that zero is exact.
constexpr double kMaxX = 16.0;
constexpr double kMaxY = 11.0;
constexpr double kMaxSpeed = 12.75;
constexpr std::uint32_t kPositionLevels = 2047;
constexpr std::uint32_t kSpeedLevels = 511;
constexpr int kMaxUnum = 11;

using Symbols = std::array<std::uint8_t, kDataSymbols>;

/// Bits in order, six to a symbol, the first bit highest.
class BitWriter {
  public:
    void put(std::uint32_t value, int bits) {
        for (int i = bits - 1; i >= 0; --i, ++at_) {
            const auto bit = static_cast<std::uint8_t>((value >> i) & 1U);
            symbols[at_ / 6] = static_cast<std::uint8_t>(symbols[at_ / 6] | (bit << (5 - at_ % 6)));
        }
    }
    void put_scaled(double value, double max, std::uint32_t levels, int bits) {
        const double bounded = std::isfinite(value) ? std::clamp(value, -max, max) : 0.0;
        put(static_cast<std::uint32_t>(std::lround((bounded + max) / (2.0 * max) * (levels - 1))), bits);
    }
    void put_point(const Vec2& point) {
        put_scaled(point.x(), kMaxX, kPositionLevels, 11);
        put_scaled(point.y(), kMaxY, kPositionLevels, 11);
    }
    Symbols symbols{};

  private:
    std::size_t at_ = 0;
};

class BitReader {
  public:
    explicit BitReader(const Symbols& symbols) : symbols_(symbols) {}
    std::uint32_t get(int bits) {
        std::uint32_t value = 0;
        for (int i = 0; i < bits; ++i, ++at_)
            value = (value << 1U) | ((symbols_[at_ / 6] >> (5 - at_ % 6)) & 1U);
        return value;
    }
    double get_scaled(double max, std::uint32_t levels, int bits) {
        // 2 * max * k - max * n is exact for the middle level, hence gives 0 there.
        const double k = std::min(get(bits), levels - 1);
        const double n = levels - 1;
        return (2.0 * k - n) * (max / n);
    }
    Vec2 get_point() {
        const double x = get_scaled(kMaxX, kPositionLevels, 11);
        const double y = get_scaled(kMaxY, kPositionLevels, 11);
        return {x, y};
    }

  private:
    const Symbols& symbols_;
    std::size_t at_ = 0;
};

/// Polynomial checksum modulo a prime below 2^12: finds every single changed symbol and every swap.
std::uint32_t check_of(const Symbols& symbols) {
    std::uint32_t sum = 1;
    for (const std::uint8_t symbol : symbols) sum = (sum * 67U + symbol) % 4093U;
    return sum;
}

}  // namespace

std::string encode(const Message& message) {
    std::string text;
    encode(message, text);
    return text;
}

void encode(const Message& message, std::string& text) {
    BitWriter w;
    w.put(static_cast<std::uint32_t>(std::clamp(message.unum, 0, kMaxUnum)), 4);
    w.put_point(message.position);
    w.put(message.fallen ? 1 : 0, 1);
    w.put(message.ball ? 1 : 0, 1);
    w.put_point(message.ball.value_or(Vec2::Zero()));
    const Vec2 velocity = message.ball ? message.ball_velocity : Vec2(Vec2::Zero());
    w.put_scaled(velocity.x(), kMaxSpeed, kSpeedLevels, 9);
    w.put_scaled(velocity.y(), kMaxSpeed, kSpeedLevels, 9);
    w.put(message.claims_k1 ? 1 : 0, 1);
    w.put(message.target ? 1 : 0, 1);
    w.put_point(message.target.value_or(Vec2::Zero()));
    w.put(static_cast<std::uint32_t>(std::clamp(message.k2, 0, kMaxUnum)), 4);
    w.put(static_cast<std::uint32_t>(message.kicks) & 15U, 4);

    text.assign(1, kTag);
    for (const std::uint8_t symbol : w.symbols) text += kAlphabet[symbol];
    const std::uint32_t check = check_of(w.symbols);
    text += kAlphabet[check / 64];
    text += kAlphabet[check % 64];
}

std::optional<Message> decode(std::string_view text) {
    if (text.size() != kMessageBytes || text.front() != kTag) return std::nullopt;
    Symbols symbols{};
    std::uint32_t check = 0;
    for (std::size_t i = 1; i < kMessageBytes; ++i) {
        const std::size_t symbol = kAlphabet.find(text[i]);
        if (symbol == std::string_view::npos) return std::nullopt;
        if (i <= kDataSymbols)
            symbols[i - 1] = static_cast<std::uint8_t>(symbol);
        else
            check = check * 64 + static_cast<std::uint32_t>(symbol);
    }
    if (check != check_of(symbols)) return std::nullopt;

    BitReader r(symbols);
    Message message;
    message.unum = static_cast<int>(r.get(4));
    if (message.unum < 1 || message.unum > kMaxUnum) return std::nullopt;
    message.position = r.get_point();
    message.fallen = r.get(1) != 0;
    const bool has_ball = r.get(1) != 0;
    const Vec2 ball = r.get_point();
    if (has_ball) message.ball = ball;
    message.ball_velocity.x() = r.get_scaled(kMaxSpeed, kSpeedLevels, 9);
    message.ball_velocity.y() = r.get_scaled(kMaxSpeed, kSpeedLevels, 9);
    message.claims_k1 = r.get(1) != 0;
    const bool has_target = r.get(1) != 0;
    const Vec2 target = r.get_point();
    if (has_target) message.target = target;
    message.k2 = static_cast<int>(r.get(4));
    if (message.k2 > kMaxUnum) return std::nullopt;
    message.kicks = static_cast<int>(r.get(4));
    return message;
}

}  // namespace k3d::agent::talk
