#pragma once

#include <functional>
#include <string>

#include "docs/command_table.h"

namespace scatter::test {

using Check = std::function<void(const Called&)>;

/// Both.
[[nodiscard]] Check operator+(Check first, Check second);

/// The output holds this text.
[[nodiscard]] Check says(const std::string& text);

/// There is such a file, and it is not empty.
[[nodiscard]] Check leaves(const std::string& file);

/// A column of a frames.csv is above zero in some frame.
[[nodiscard]] Check has(const std::string& csv, const std::string& column);

/// It changes from frame to frame, upwards at least once.
[[nodiscard]] Check grows(const std::string& csv, const std::string& column);

/// Two files have the same values in a column, or have not.
[[nodiscard]] Check same(const std::string& csv, const std::string& other, const std::string& column);
[[nodiscard]] Check differs(const std::string& csv, const std::string& other, const std::string& column);

/// The highest value of a column.
[[nodiscard]] double highestIn(const std::filesystem::path& csv, const std::string& column);

/// The first frame in which a column is above zero; 0: never.
[[nodiscard]] int firstIn(const std::filesystem::path& csv, const std::string& column);

}  // namespace scatter::test
