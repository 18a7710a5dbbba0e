#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace scatter {

enum class ErrorKind {
  kInput,     ///< What was asked for, or given, is wrong or cannot be had.
  kDiskFull,  ///< It was right, and there is no room for it.
};

/// Why something could not be read or made: one line that says what, where and how to mend it.
struct Error {
  std::string message;
  ErrorKind kind = ErrorKind::kInput;
};

/// A value, or the error that kept it from being made. Files and creation return this; nothing that
/// runs inside a physics step throws.
template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> fail(std::string message) {
  return tl::unexpected<Error>(Error{std::move(message)});
}

}  // namespace scatter
