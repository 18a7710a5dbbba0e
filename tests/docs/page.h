#pragma once

#include <string>
#include <vector>

namespace scatter::test {

/// A page of the documentation, by its path in the source tree. Throws std::runtime_error if there is none.
[[nodiscard]] std::string readPage(const std::string& name);

/// Every command that a page of Markdown tells its readers to call, once each, in order: what begins with
/// "scatter ",
/// "./run" or "./test" in backticks and on the lines of code blocks. What follows two spaces, a '#', or an
/// option that is explained is left out; a bare `scatter` is no command.
[[nodiscard]] std::vector<std::string> commandsOf(const std::string& page);

/// The cells of the page's tables below a heading that begins with these words, without the header.
[[nodiscard]] std::vector<std::vector<std::string>> tableBelow(const std::string& page,
                                                               const std::string& heading);

/// The lines of the first code block below a heading that begins with these words.
[[nodiscard]] std::vector<std::string> codeBelow(const std::string& page, const std::string& heading);

/// The words of a command, as a shell that knows no quotes would have them.
[[nodiscard]] std::vector<std::string> wordsOf(const std::string& command);

}  // namespace scatter::test
