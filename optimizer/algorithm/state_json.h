// SPDX-License-Identifier: BSD-3-Clause
// Saved states as JSON: numbers that come back with the same bits, errors that name the place.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/network/network.h"
#include "optimizer/algorithm/error.h"

namespace k3d::optimizer::algorithm {

/// A number if it is finite (17 digits where needed), else "inf", "-inf" or "nan".
nlohmann::json exact(double value);
nlohmann::json exact(const std::vector<double>& values);

/// Reads one JSON value; every error is an AlgorithmError "SOURCE: PATH: what". Holds a reference.
class Reader {
  public:
    Reader(const nlohmann::json& value, std::string source, std::string path)
        : value_(value), source_(std::move(source)), path_(std::move(path)) {}

    [[noreturn]] void fail(const std::string& what) const;
    Reader operator[](const char* key) const;  ///< of an object that must have it
    bool has(const char* key) const;
    Reader entry(std::size_t index) const;  ///< of a list; index < size()
    std::size_t size() const;               ///< of what must be a list
    void each(const std::function<void(const Reader&)>& read) const;

    double number() const;  ///< finite, or one of the words of exact()
    double finite() const;
    int integer(int low, int high) const;
    std::uint64_t unsigned_integer() const;
    bool flag() const;
    std::string text() const;
    bool is_null() const { return value_.is_null(); }
    std::vector<double> finite_list() const;
    std::vector<double> finite_list(std::size_t length) const;
    const nlohmann::json& json() const { return value_; }
    const std::string& source() const { return source_; }

  private:
    const nlohmann::json& value_;
    std::string source_;
    std::string path_;
};

/// Networks stand in states in the agent's file format.
nlohmann::json network_json(const network::Definition& definition);
network::Definition read_network(const Reader& reader);

}  // namespace k3d::optimizer::algorithm
