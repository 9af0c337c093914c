// SPDX-License-Identifier: BSD-3-Clause
// Codes a team message into 20 printable bytes: a tag, 17 symbols of 6 bits, a two-symbol check.
#include "agent/talk/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "common/wire/percepts.h"

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

// A quantity from -max to max takes its bits' number of levels less one: odd, so that zero is exact.
struct Scale {
    double max;
    int bits;
    std::uint32_t levels() const { return (1U << bits) - 1; }
};
struct PlaneScale {
    Scale x, y;
};
// The field and one metre around it.
constexpr PlaneScale kSelfScale{{16.0, 9}, {11.0, 9}};    // to 63 and 43 mm
constexpr PlaneScale kBallScale{{16.0, 10}, {11.0, 9}};   // to 31 and 43 mm
constexpr PlaneScale kTargetScale{{16.0, 9}, {11.0, 8}};  // to 63 and 87 mm
constexpr PlaneScale kVelocityScale{{12.75, 7}, {12.75, 7}};             // to 0.2 m/s
constexpr PlaneScale kSightingScale{{kTellReach, 7}, {kTellReach, 7}};  // from the speaker, to 0.1 m
constexpr int kUnumBits = 4;
constexpr int kSpareBits = 4;  // for what is yet to be told; zero
using wire::kMaxUnum;

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
    void put_flag(bool flag) { put(flag ? 1 : 0, 1); }
    void put_unum(int unum) {
        put(static_cast<std::uint32_t>(std::clamp(unum, 0, kMaxUnum)), kUnumBits);
    }
    void put_scaled(double value, const Scale& scale) {
        const double bounded = std::isfinite(value) ? std::clamp(value, -scale.max, scale.max) : 0.0;
        const double level = (bounded + scale.max) / (2.0 * scale.max) * (scale.levels() - 1);
        put(static_cast<std::uint32_t>(std::lround(level)), scale.bits);
    }
    void put_vector(const Vec2& vector, const PlaneScale& scale) {
        put_scaled(vector.x(), scale.x);
        put_scaled(vector.y(), scale.y);
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
    bool get_flag() { return get(1) != 0; }
    int get_unum() { return static_cast<int>(get(kUnumBits)); }
    double get_scaled(const Scale& scale) {
        // 2 * max * k - max * n is exact for the middle level, hence gives 0 there.
        const double n = scale.levels() - 1;
        const double k = std::min(static_cast<double>(get(scale.bits)), n);
        return (2.0 * k - n) * (scale.max / n);
    }
    Vec2 get_vector(const PlaneScale& scale) {
        const double x = get_scaled(scale.x);
        const double y = get_scaled(scale.y);
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

/// Whom the message can tell of.
const Sighting* tellable(const Message& message) {
    if (!message.opponent || message.opponent->unum < 1 || message.opponent->unum > kMaxUnum)
        return nullptr;
    const Vec2 from_speaker = message.opponent->position - message.position;
    return from_speaker.cwiseAbs().maxCoeff() <= kTellReach ? &*message.opponent : nullptr;
}

}  // namespace

std::string encode(const Message& message) {
    std::string text;
    encode(message, text);
    return text;
}

void encode(const Message& message, std::string& text) {
    BitWriter w;
    w.put_unum(message.unum);
    w.put_vector(message.position, kSelfScale);
    w.put_flag(message.fallen);
    w.put_flag(message.ball.has_value());
    w.put_vector(message.ball.value_or(Vec2::Zero()), kBallScale);
    w.put_vector(message.ball ? message.ball_velocity : Vec2(Vec2::Zero()), kVelocityScale);
    w.put_flag(message.claims_k1);
    w.put_flag(message.target.has_value());
    w.put_vector(message.target.value_or(Vec2::Zero()), kTargetScale);
    w.put_unum(message.k2);
    w.put(0, kSpareBits);
    const Sighting* opponent = tellable(message);
    w.put_unum(opponent != nullptr ? opponent->unum : 0);
    w.put_vector(opponent != nullptr ? Vec2(opponent->position - message.position) : Vec2(Vec2::Zero()),
                 kSightingScale);

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
    message.unum = r.get_unum();
    if (message.unum < 1 || message.unum > kMaxUnum) return std::nullopt;
    message.position = r.get_vector(kSelfScale);
    message.fallen = r.get_flag();
    const bool has_ball = r.get_flag();
    const Vec2 ball = r.get_vector(kBallScale);
    if (has_ball) message.ball = ball;
    message.ball_velocity = r.get_vector(kVelocityScale);
    message.claims_k1 = r.get_flag();
    const bool has_target = r.get_flag();
    const Vec2 target = r.get_vector(kTargetScale);
    if (has_target) message.target = target;
    message.k2 = r.get_unum();
    r.get(kSpareBits);
    const int opponent = r.get_unum();
    const Vec2 from_speaker = r.get_vector(kSightingScale);
    if (opponent != 0) message.opponent = {opponent, message.position + from_speaker};
    if (message.k2 > kMaxUnum || opponent > kMaxUnum) return std::nullopt;
    return message;
}

}  // namespace k3d::agent::talk
