// SPDX-License-Identifier: BSD-3-Clause
// Recordings written and read again; files cut short, damaged and forged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>
#include <xxhash.h>
#include <zstd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "server/recording/record_reader.h"
#include "server/recording/record_writer.h"

namespace k3d::server::recording {
namespace {

using ::testing::HasSubstr;

/// An entry as text, to compare.
std::string text_of(const Entry& entry) {
    struct Text {
        std::string operator()(const Header& h) { return "H " + h.code_version + " " + h.config; }
        std::string operator()(const Accepted& a) {
            return "A " + std::to_string(a.connection) + (a.port == Port::Agent ? " agent" : " monitor") +
                   (a.commands ? " commands " : " ") + a.peer;
        }
        std::string operator()(const Received& r) {
            return "F " + std::to_string(r.connection) + " " + r.frame;
        }
        std::string operator()(const Left& l) {
            return "L " + std::to_string(l.connection) + " " + l.why;
        }
        std::string operator()(const StepEnd& s) { return "S " + std::to_string(s.digest); }
        std::string operator()(const End& e) { return "E " + std::to_string(e.outcome); }
    };
    return std::visit(Text{}, entry);
}

class RecordFile : public ::testing::Test {
  protected:
    RecordFile()
        : name_((std::filesystem::temp_directory_path() /
                 ("k3d-record-test-" + std::to_string(getpid())))
                    .string()) {}
    ~RecordFile() override { std::filesystem::remove(name_); }

    std::string bytes() const {
        std::ifstream in(name_, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    /// A small recording in three blocks.
    std::string small() {
        {
            RecordWriter writer(name_, {"0.1.0+abc", "seed = 1\n"});
            writer.add({1, Port::Agent, false, "127.0.0.1:4000"});
            writer.add({2, Port::Monitor, true, "[::1]:4001"});
            for (std::uint64_t step = 0; step < 60; ++step) {
                writer.add(1, "(he1 0.5)(syn)");
                if (step == 30) writer.add({1, "peer closed"});
                writer.add(StepEnd{step * 1'000'000'007});
            }
            writer.add(End{2});
        }
        return bytes();
    }

    std::string name_;
};

/// What a reader makes of the bytes: entries, and the error if there is one.
struct Read {
    std::vector<std::string> entries;
    std::string error;

    explicit Read(const std::string& bytes) {
        std::istringstream in(bytes);
        try {
            RecordReader reader(in, "x.rec");
            entries.push_back(text_of(reader.header()));
            while (auto entry = reader.next()) entries.push_back(text_of(*entry));
        } catch (const RecordError& fault) {
            error = fault.what();
        }
    }
};

TEST_F(RecordFile, EveryKindOfEntryComesBack) {
    const Read read(small());
    EXPECT_EQ(read.error, "");
    ASSERT_EQ(read.entries.size(), 3U + 120U + 1U + 1U);
    EXPECT_EQ(read.entries[0], "H 0.1.0+abc seed = 1\n");
    EXPECT_EQ(read.entries[1], "A 1 agent 127.0.0.1:4000");
    EXPECT_EQ(read.entries[2], "A 2 monitor commands [::1]:4001");
    EXPECT_EQ(read.entries[3], "F 1 (he1 0.5)(syn)");
    EXPECT_EQ(read.entries[4], "S 0");
    EXPECT_EQ(read.entries[6], "S 1000000007");
    EXPECT_EQ(read.entries[64], "L 1 peer closed");
    EXPECT_EQ(read.entries.back(), "E 2");
}

TEST_F(RecordFile, WholeBlocksOfAKilledWriterAreReadable) {
    RecordWriter writer(name_, {"v", ""});
    for (std::uint64_t step = 0; step < 120; ++step) writer.add(StepEnd{step});
    const Read read(bytes());  // while the writer still holds 20 steps
    EXPECT_EQ(read.error, "");
    EXPECT_EQ(read.entries.size(), 101U);
    EXPECT_EQ(read.entries.back(), "S 99");
}

TEST_F(RecordFile, CutAnywhereItEndsThereOrSaysSo) {
    const std::string whole = small();
    const Read all(whole);
    int clean = 0;
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Read read(whole.substr(0, size));
        clean += read.error.empty() ? 1 : 0;
        ASSERT_LE(read.entries.size(), all.entries.size());
        EXPECT_TRUE(std::equal(read.entries.begin(), read.entries.end(), all.entries.begin()))
            << "cut at " << size;
    }
    EXPECT_EQ(clean, 2) << "behind the first and the second block";
    EXPECT_THAT(Read(whole.substr(0, whole.size() - 1)).error, HasSubstr("cut short"));
}

TEST_F(RecordFile, ADamagedByteIsNoticed) {
    const std::string whole = small();
    const Read all(whole);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        const Read read(damaged);
        EXPECT_THAT(read.error, HasSubstr("x.rec: ")) << "byte " << at;
        EXPECT_TRUE(std::equal(read.entries.begin(), read.entries.end(), all.entries.begin()))
            << "byte " << at;
    }
}

/// A block as the format has it, around any bytes.
std::string block(const std::string& plain) {
    std::string stored(ZSTD_compressBound(plain.size()), '\0');
    stored.resize(ZSTD_compress(stored.data(), stored.size(), plain.data(), plain.size(), 1));
    std::string head;
    const auto append = [&head](std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) head += static_cast<char>(value >> (8 * i));
    };
    append(stored.size(), 4);
    append(plain.size(), 4);
    append(XXH3_64bits(stored.data(), stored.size()), 8);
    return head + stored;
}

std::string with_header(const std::string& plain) {
    return std::string(kMagic) + block(std::string("H\1v\0", 4)) + block(plain);
}

TEST(Record, ForgedBlocksAreRefusedWithTheirPlace) {
    EXPECT_EQ(Read("(RSG 0 1)").error, "x.rec: is no recording of this server (of this version)");
    EXPECT_EQ(Read("").error, "x.rec: is no recording of this server (of this version)");
    EXPECT_THAT(Read(std::string(kMagic)).error, HasSubstr("nothing behind the first line"));
    EXPECT_THAT(Read(std::string(kMagic) + block("E\1")).error, HasSubstr("no header"));
    EXPECT_THAT(Read(with_header(std::string("H\1v\0", 4))).error, HasSubstr("a second header"));
    EXPECT_EQ(Read(with_header("?")).error,
              "x.rec: block at byte 52 (unpacked byte 1): an entry of kind 63");
    EXPECT_THAT(Read(with_header("F\1\7abc")).error,
                HasSubstr("an entry of 7 bytes where 3 are left"));
    EXPECT_THAT(Read(with_header(std::string("F\0\0", 3))).error, HasSubstr("connection 0"));
    EXPECT_THAT(Read(with_header("F" + std::string(12, '\xFF'))).error,
                HasSubstr("a number without end"));
    EXPECT_THAT(Read(with_header("S1234567")).error, HasSubstr("8 bytes where 7 are left"));
    EXPECT_THAT(Read(with_header("A\1\5")).error, HasSubstr("port 5"));
    EXPECT_THAT(Read(with_header("E\x20")).error, HasSubstr("outcome 32"));
    const std::string huge = std::string(kMagic) + std::string("\xFF\xFF\xFF\xFF\1\0\0\0", 8) +
                             std::string(8, 'x');
    EXPECT_THAT(Read(huge).error, HasSubstr("a block of 4294967295 bytes"));
    const std::string bomb = std::string(kMagic) + std::string("\1\0\0\0\xFF\xFF\xFF\xFF", 8) +
                             std::string(9, 'x');
    EXPECT_THAT(Read(bomb).error, HasSubstr("4294967295 unpacked, limit"));
}

RC_GTEST_PROP(Record, AnyEntriesComeBack, ()) {
    const std::string name =
        (std::filesystem::temp_directory_path() / ("k3d-record-prop-" + std::to_string(getpid())))
            .string();
    const Header header{*rc::gen::string<std::string>(), *rc::gen::string<std::string>()};
    std::vector<std::string> written{text_of(header)};
    {
        RecordWriter writer(name, header);
        const int count = *rc::gen::inRange(0, 200);
        for (int i = 0; i < count; ++i) {
            const int who = *rc::gen::positive<int>();
            const std::string text = *rc::gen::string<std::string>();
            switch (*rc::gen::inRange(0, 5)) {
                case 0: {
                    const Accepted accepted{
                        who, *rc::gen::element(Port::Agent, Port::Monitor),
                        *rc::gen::arbitrary<bool>(), text};
                    writer.add(accepted);
                    written.push_back(text_of(accepted));
                    break;
                }
                case 1:
                    writer.add(who, text);
                    written.push_back(text_of(Received{who, text}));
                    break;
                case 2:
                    writer.add(Left{who, text});
                    written.push_back(text_of(Left{who, text}));
                    break;
                default: {
                    const StepEnd end{*rc::gen::arbitrary<std::uint64_t>()};
                    writer.add(end);
                    written.push_back(text_of(end));
                }
            }
        }
    }
    std::ifstream in(name, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    std::filesystem::remove(name);
    const Read read(bytes.str());
    RC_ASSERT(read.error == "");
    RC_ASSERT(read.entries == written);
}

TEST(Record, AFileThatCannotBeWrittenIsNamed) {
    try {
        RecordWriter writer("/no/such/folder/x.rec", {});
        FAIL() << "no error";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "cannot write recording /no/such/folder/x.rec: No such file or directory");
    }
}

}  // namespace
}  // namespace k3d::server::recording
