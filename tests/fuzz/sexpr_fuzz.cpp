// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as s-expressions: what is read is whole, inside the text and within the bounds.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "common/sexpr/reader.h"

namespace {

using namespace k3d;

struct Walk {
    std::string_view text;
    std::size_t nodes = 0;

    void visit(const sexpr::Node& node, int depth) {
        if (depth > sexpr::kMaxDepth || ++nodes > sexpr::kMaxNodes) std::abort();
        if (node.is_atom()) {
            const std::string_view atom = node.atom();
            if (atom.empty() || atom.data() < text.data() ||
                atom.data() + atom.size() > text.data() + text.size()) {
                std::abort();
            }
            static_cast<void>(node.number());
            static_cast<void>(node.integer());
        }
        int count = 0;
        for (auto n = node.first(); n; n = n->next(), ++count) visit(*n, depth + 1);
        if (count != node.size() || node.at(count)) std::abort();
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static sexpr::Document document;  // reused, as the decoders reuse it
    Walk walk{std::string_view(reinterpret_cast<const char*>(data), size)};
    document.parse(walk.text);
    for (auto n = document.first(); n; n = n->next()) walk.visit(*n, 0);
    return 0;
}
