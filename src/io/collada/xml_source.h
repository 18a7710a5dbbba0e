#pragma once

#include <scatter/result.h>

#include <memory>
#include <string>
#include <string_view>

namespace pugi {
class xml_node;
}

namespace scatter::io {

/// `text` in quotes, shortened and on one line, for use in a message.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// An XML document and what its error messages need. Views the text and the name given, which must
/// outlive it.
class XmlSource {
 public:
  /// Fails if the text is not well-formed or nested so deeply that following it could exhaust the stack.
  [[nodiscard]] static Result<XmlSource> parse(std::string_view text, std::string_view name);

  XmlSource(XmlSource&&) noexcept;
  XmlSource& operator=(XmlSource&&) noexcept;
  ~XmlSource();

  /// The outermost element.
  [[nodiscard]] pugi::xml_node root() const;

  /// A line that reads "NAME:LINE: <element>: what".
  [[nodiscard]] std::string describeAt(const pugi::xml_node& node, std::string_view what) const;

  /// The same as an error.
  [[nodiscard]] tl::unexpected<Error> failAt(const pugi::xml_node& node, std::string_view what) const;

  /// The first child element of that name; `purpose` ends the message if there is none.
  [[nodiscard]] Result<pugi::xml_node> child(const pugi::xml_node& parent, const char* name,
                                             std::string_view purpose) const;

  /// The first element with that id; none if there is no such element.
  [[nodiscard]] pugi::xml_node findId(std::string_view id) const;

  /// The element that the attribute's "#id" names; it must be a `kind`. The error is a phrase.
  [[nodiscard]] Result<pugi::xml_node> resolve(const pugi::xml_node& node, const char* attribute,
                                               const char* kind) const;

  /// The same, with an error as failAt gives it.
  [[nodiscard]] Result<pugi::xml_node> follow(const pugi::xml_node& node, const char* attribute,
                                              const char* kind) const;

 private:
  struct Document;

  XmlSource(std::string_view text, std::string_view name);

  std::string_view text_;
  std::string_view name_;
  std::unique_ptr<Document> document_;
};

}  // namespace scatter::io
