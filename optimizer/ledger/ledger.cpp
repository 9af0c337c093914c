// SPDX-License-Identifier: BSD-3-Clause
#include "optimizer/ledger/ledger.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <filesystem>

namespace k3d::optimizer::ledger {

namespace {

constexpr int kVersion = 1;
constexpr int kApplication = 0x6b336c67;  // "k3lg", tells our files from other SQLite files
constexpr int kBusyMs = 10'000;

constexpr const char* kTables = R"(
CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE episodes (
    phase INTEGER NOT NULL, generation INTEGER NOT NULL, candidate INTEGER NOT NULL,
    episode INTEGER NOT NULL, seed INTEGER NOT NULL, fingerprint TEXT NOT NULL,
    status TEXT NOT NULL, reason TEXT NOT NULL, fitness REAL NOT NULL, simulated_s REAL NOT NULL,
    result TEXT NOT NULL, attempt INTEGER NOT NULL, wall_s REAL NOT NULL, worker TEXT NOT NULL,
    PRIMARY KEY (phase, generation, candidate, episode)) STRICT, WITHOUT ROWID;
CREATE TABLE failed_tries (
    phase INTEGER NOT NULL, generation INTEGER NOT NULL, candidate INTEGER NOT NULL,
    episode INTEGER NOT NULL, attempt INTEGER NOT NULL, reason TEXT NOT NULL, worker TEXT NOT NULL,
    PRIMARY KEY (phase, generation, candidate, episode, attempt)) STRICT, WITHOUT ROWID;
CREATE TABLE rounds (number INTEGER PRIMARY KEY, state TEXT NOT NULL) STRICT;
CREATE TABLE generations (number INTEGER PRIMARY KEY, line TEXT NOT NULL) STRICT;
CREATE TABLE candidates (
    number INTEGER PRIMARY KEY, generation INTEGER NOT NULL, payload TEXT NOT NULL) STRICT;
)";

constexpr const char* kColumns =
    "phase, generation, candidate, episode, seed, fingerprint, status, reason, fitness, "
    "simulated_s, result, attempt, wall_s, worker";
constexpr const char* kOrder = "phase, generation, candidate, episode";
constexpr const char* kAtKey = "phase = ? AND generation = ? AND candidate = ? AND episode = ?";

/// Binds values to the question marks of a statement, in order.
class Binder {
  public:
    explicit Binder(SQLite::Statement& statement) : statement_(statement) {}
    Binder& operator<<(std::int64_t value) { return bind(value); }
    Binder& operator<<(int value) { return bind(value); }
    Binder& operator<<(std::uint64_t value) { return bind(static_cast<std::int64_t>(value)); }
    Binder& operator<<(double value) { return bind(value); }
    Binder& operator<<(const std::string& value) { return bind(value); }
    Binder& operator<<(const episode::Key& key) {
        return *this << static_cast<int>(key.phase) << key.generation << key.candidate
                     << key.episode;
    }

  private:
    template <class T>
    Binder& bind(const T& value) {
        statement_.bind(++next_, value);
        return *this;
    }
    SQLite::Statement& statement_;
    int next_ = 0;
};

episode::Key read_key(SQLite::Statement& s) {
    const int phase = s.getColumn(0).getInt();
    if (phase < 0 || phase > static_cast<int>(episode::Phase::Baseline)) {
        throw LedgerError(fmt::format("an episode is of phase {}, which there is not", phase));
    }
    return {static_cast<episode::Phase>(phase), s.getColumn(1).getInt(),
            static_cast<std::uint64_t>(s.getColumn(2).getInt64()), s.getColumn(3).getInt()};
}

Row read_row(SQLite::Statement& s) {
    Row row;
    row.key = read_key(s);
    row.seed = static_cast<std::uint64_t>(s.getColumn(4).getInt64());
    row.fingerprint = s.getColumn(5).getString();
    row.status = s.getColumn(6).getString();
    row.reason = s.getColumn(7).getString();
    row.fitness = s.getColumn(8).getDouble();
    row.simulated_s = s.getColumn(9).getDouble();
    row.result = s.getColumn(10).getString();
    row.attempt = s.getColumn(11).getInt();
    row.wall_s = s.getColumn(12).getDouble();
    row.worker = s.getColumn(13).getString();
    return row;
}

int number_of(SQLite::Database& db, const char* pragma) {
    return db.execAndGet(std::string("PRAGMA ") + pragma).getInt();
}

void write_new(const std::string& path, const Facts& facts) {
    SQLite::Database db(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyMs);
    db.exec("PRAGMA journal_mode = WAL");
    SQLite::Transaction transaction(db);
    db.exec(kTables);
    for (const auto& [name, value] : facts) {
        SQLite::Statement add(db, "INSERT INTO facts VALUES (?, ?)");
        Binder(add) << name << value;
        add.exec();
    }
    db.exec(fmt::format("PRAGMA application_id = {}", kApplication));
    db.exec(fmt::format("PRAGMA user_version = {}", kVersion));
    transaction.commit();
}

}  // namespace

struct Ledger::Impl {
    std::string path;
    SQLite::Database db;
    SQLite::Statement insert;
    SQLite::Statement select;

    Impl(std::string file, SQLite::Database open)
        : path(std::move(file)),
          db(std::move(open)),
          insert(db, fmt::format("INSERT OR IGNORE INTO episodes ({}) VALUES "
                                 "(?,?,?,?,?,?,?,?,?,?,?,?,?,?)",
                                 kColumns)),
          select(db, fmt::format("SELECT {} FROM episodes WHERE {}", kColumns, kAtKey)) {}

    /// Whatever goes wrong names the file.
    template <class Work>
    static auto guard(const std::string& path, const Work& work) {
        try {
            return work();
        } catch (const SQLite::Exception& error) {
            throw LedgerError(fmt::format("{}: {}", path, error.what()));
        } catch (const std::filesystem::filesystem_error& error) {
            throw LedgerError(fmt::format("{}: {}", path, error.what()));
        } catch (const nlohmann::json::exception& error) {
            throw LedgerError(fmt::format("{}: {}", path, error.what()));
        } catch (const LedgerError& error) {
            const std::string text = error.what();
            if (text.rfind(path, 0) == 0) throw;
            throw LedgerError(path + ": " + text);
        }
    }
    template <class Work>
    auto guard(const Work& work) const {
        return guard(path, work);
    }

    std::optional<Row> at(const episode::Key& key) {
        select.reset();
        Binder(select) << key;
        std::optional<Row> row;
        if (select.executeStep()) row = read_row(select);
        select.reset();
        return row;
    }
};

Ledger::Ledger(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Ledger::Ledger(Ledger&&) noexcept = default;
Ledger& Ledger::operator=(Ledger&&) noexcept = default;
Ledger::~Ledger() = default;

Ledger Ledger::create(const std::string& path, const Facts& facts) {
    return Impl::guard(path, [&] {
        if (std::filesystem::exists(path)) throw LedgerError("there is a file of this name");
        // Whoever finds a ledger finds a whole one: it gets its name when it is complete.
        const std::string unborn = path + ".new";
        std::filesystem::remove(unborn);
        write_new(unborn, facts);
        std::filesystem::rename(unborn, path);
        return open(path, Access::Write);
    });
}

Ledger Ledger::open(const std::string& path, Access access) {
    return Impl::guard(path, [&] {
        if (!std::filesystem::exists(path)) throw LedgerError("there is no such file");
        const int flags =
            access == Access::Write ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY;
        SQLite::Database db(path, flags, kBusyMs);
        if (number_of(db, "application_id") != kApplication) {
            throw LedgerError("this is no ledger of k3d-optimizer");
        }
        if (const int version = number_of(db, "user_version"); version != kVersion) {
            throw LedgerError(fmt::format("it has version {}, this program reads {}", version,
                                          kVersion));
        }
        if (access == Access::Write) {
            // What is in the ledger is confirmed and never delivered again: it must outlast a
            // power cut.
            db.exec("PRAGMA synchronous = FULL");
            const std::string verdict = db.execAndGet("PRAGMA quick_check(1)").getString();
            if (verdict != "ok") throw LedgerError("it is damaged: " + verdict);
        }
        return Ledger(std::make_unique<Impl>(path, std::move(db)));
    });
}

Facts Ledger::facts() const {
    return impl_->guard([&] {
        Facts facts;
        SQLite::Statement s(impl_->db, "SELECT name, value FROM facts");
        while (s.executeStep()) facts[s.getColumn(0).getString()] = s.getColumn(1).getString();
        return facts;
    });
}

void Ledger::set_fact(const std::string& name, const std::string& value) {
    impl_->guard([&] {
        SQLite::Statement s(impl_->db, "INSERT OR REPLACE INTO facts VALUES (?, ?)");
        Binder(s) << name << value;
        s.exec();
    });
}

std::vector<Row> Ledger::add(const std::vector<Row>& rows, const std::vector<FailedTry>& failed) {
    return impl_->guard([&] {
        std::vector<Row> contradicted;
        SQLite::Transaction transaction(impl_->db);
        for (const Row& row : rows) {
            impl_->insert.reset();
            Binder(impl_->insert) << row.key << row.seed << row.fingerprint << row.status
                                  << row.reason << row.fitness << row.simulated_s << row.result
                                  << row.attempt << row.wall_s << row.worker;
            if (impl_->insert.exec() > 0) continue;
            const auto first = impl_->at(row.key);
            if (first && !first->same_result(row)) contradicted.push_back(row);
        }
        for (const FailedTry& one : failed) {
            SQLite::Statement s(impl_->db,
                                "INSERT OR IGNORE INTO failed_tries VALUES (?,?,?,?,?,?,?)");
            Binder(s) << one.key << one.attempt << one.reason << one.worker;
            s.exec();
        }
        transaction.commit();
        return contradicted;
    });
}

std::optional<Row> Ledger::find(const episode::Key& key) const {
    return impl_->guard([&] { return impl_->at(key); });
}

std::vector<Row> Ledger::rows() const {
    return impl_->guard([&] {
        std::vector<Row> rows;
        SQLite::Statement s(impl_->db,
                            fmt::format("SELECT {} FROM episodes ORDER BY {}", kColumns, kOrder));
        while (s.executeStep()) rows.push_back(read_row(s));
        return rows;
    });
}

std::vector<FailedTry> Ledger::failed_tries() const {
    return impl_->guard([&] {
        std::vector<FailedTry> tries;
        SQLite::Statement s(impl_->db, fmt::format("SELECT {}, attempt, reason, worker FROM "
                                                   "failed_tries ORDER BY {}, attempt",
                                                   kOrder, kOrder));
        while (s.executeStep()) {
            tries.push_back({read_key(s), s.getColumn(4).getInt(), s.getColumn(5).getString(),
                             s.getColumn(6).getString()});
        }
        return tries;
    });
}

int Ledger::count_failed(const episode::Key& key) const {
    return impl_->guard([&] {
        SQLite::Statement s(impl_->db,
                            fmt::format("SELECT count(*) FROM failed_tries WHERE {}", kAtKey));
        Binder(s) << key;
        s.executeStep();
        return s.getColumn(0).getInt();
    });
}

void Ledger::save_round(const Round& round, const std::vector<Candidate>& candidates) {
    impl_->guard([&] {
        SQLite::Transaction transaction(impl_->db);
        impl_->db.exec("DELETE FROM rounds");
        SQLite::Statement state(impl_->db, "INSERT INTO rounds VALUES (?, ?)");
        Binder(state) << round.number << round.state;
        state.exec();
        for (const nlohmann::json& line : round.log) {
            SQLite::Statement s(impl_->db, "INSERT OR REPLACE INTO generations VALUES (?, ?)");
            Binder(s) << line.at("generation").get<int>() << line.dump();
            s.exec();
        }
        for (const Candidate& candidate : candidates) {
            SQLite::Statement s(impl_->db, "INSERT OR IGNORE INTO candidates VALUES (?, ?, ?)");
            Binder(s) << candidate.number << candidate.generation << candidate.payload;
            s.exec();
        }
        transaction.commit();
    });
}

std::optional<Round> Ledger::last_round() const {
    return impl_->guard([&]() -> std::optional<Round> {
        SQLite::Statement s(impl_->db,
                            "SELECT number, state FROM rounds ORDER BY number DESC LIMIT 1");
        if (!s.executeStep()) return std::nullopt;
        return Round{s.getColumn(0).getInt(), s.getColumn(1).getString(), {}};
    });
}

std::vector<nlohmann::json> Ledger::log() const {
    return impl_->guard([&] {
        std::vector<nlohmann::json> lines;
        SQLite::Statement s(impl_->db, "SELECT line FROM generations ORDER BY number");
        while (s.executeStep()) {
            lines.push_back(nlohmann::json::parse(s.getColumn(0).getString()));
        }
        return lines;
    });
}

std::vector<Candidate> Ledger::candidates() const {
    return impl_->guard([&] {
        std::vector<Candidate> candidates;
        SQLite::Statement s(impl_->db,
                            "SELECT number, generation, payload FROM candidates ORDER BY number");
        while (s.executeStep()) {
            candidates.push_back({static_cast<std::uint64_t>(s.getColumn(0).getInt64()),
                                  s.getColumn(1).getInt(), s.getColumn(2).getString()});
        }
        return candidates;
    });
}

Ledger::Totals Ledger::totals() const {
    return impl_->guard([&] {
        SQLite::Statement s(impl_->db,
                            "SELECT count(*), coalesce(sum(status = 'failed'), 0), "
                            "coalesce(sum(simulated_s), 0.0), coalesce(sum(wall_s), 0.0) "
                            "FROM episodes");
        s.executeStep();
        return Totals{static_cast<std::uint64_t>(s.getColumn(0).getInt64()),
                      static_cast<std::uint64_t>(s.getColumn(1).getInt64()),
                      s.getColumn(2).getDouble(), s.getColumn(3).getDouble()};
    });
}

bool Ledger::has_result(bool of_test) const {
    return impl_->guard([&] {
        SQLite::Statement s(impl_->db,
                            "SELECT EXISTS (SELECT 1 FROM episodes WHERE status != 'failed' "
                            "AND (phase IN (?, ?)) = ?)");
        Binder(s) << static_cast<int>(episode::Phase::Test)
                  << static_cast<int>(episode::Phase::Baseline) << static_cast<int>(of_test);
        s.executeStep();
        return s.getColumn(0).getInt() != 0;
    });
}

double Ledger::simulated_before(int generation) const {
    return impl_->guard([&] {
        SQLite::Statement s(impl_->db,
                            "SELECT coalesce(sum(simulated_s), 0.0) FROM episodes WHERE phase = 0 "
                            "AND generation < ?");
        Binder(s) << generation;
        s.executeStep();
        return s.getColumn(0).getDouble();
    });
}

}  // namespace k3d::optimizer::ledger
