#include "io/collada/xml_source.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <utility>

namespace scatter::io {
namespace {

constexpr std::size_t kMaxQuoted = 60;
constexpr int kMaxElementDepth = 256;

bool isControl(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}

std::size_t lineAt(std::string_view text, std::ptrdiff_t offset) {
  const auto end = std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + end, '\n'));
}

}  // namespace

std::string inQuotes(std::string_view text) {
  std::string result(text.substr(0, kMaxQuoted));
  std::replace_if(result.begin(), result.end(), isControl, '?');
  result.insert(0, 1, '"');
  return result + (text.size() > kMaxQuoted ? "…\"" : "\"");
}

struct XmlSource::Document {
  pugi::xml_document xml;
  std::map<std::string_view, pugi::xml_node> byId;

  /// The first element that is nested too deeply, if any.
  pugi::xml_node indexIds() {
    struct Indexer : pugi::xml_tree_walker {
      std::map<std::string_view, pugi::xml_node>* index = nullptr;
      pugi::xml_node tooDeep;
      bool for_each(pugi::xml_node& node) override {
        if (const pugi::xml_attribute id = node.attribute("id")) {
          index->emplace(id.value(), node);
        }
        if (depth() >= kMaxElementDepth) {
          tooDeep = node;
        }
        return !tooDeep;
      }
    };
    Indexer indexer;
    indexer.index = &byId;
    xml.traverse(indexer);
    return indexer.tooDeep;
  }
};

XmlSource::XmlSource(std::string_view text, std::string_view name)
    : text_(text), name_(name), document_(std::make_unique<Document>()) {}
XmlSource::XmlSource(XmlSource&&) noexcept = default;
XmlSource& XmlSource::operator=(XmlSource&&) noexcept = default;
XmlSource::~XmlSource() = default;

Result<XmlSource> XmlSource::parse(std::string_view text, std::string_view name) {
  XmlSource source(text, name);
  const pugi::xml_parse_result parsed = source.document_->xml.load_buffer(text.data(), text.size());
  if (!parsed || !source.document_->xml.document_element()) {
    const std::string reason = parsed ? "it has no element" : parsed.description();
    return fail(std::string(name) + ":" + std::to_string(lineAt(text, parsed.offset)) +
                ": not a well-formed XML file: " + reason);
  }
  if (const pugi::xml_node tooDeep = source.document_->indexIds()) {
    return source.failAt(tooDeep.parent(),
                         "is nested deeper than " + std::to_string(kMaxElementDepth) + " elements");
  }
  return source;
}

pugi::xml_node XmlSource::root() const {
  return document_->xml.document_element();
}

std::string XmlSource::describeAt(const pugi::xml_node& node, std::string_view what) const {
  std::string message(name_);
  message.append(":").append(std::to_string(lineAt(text_, node.offset_debug()))).append(": <");
  message.append(std::string_view(node.name()).substr(0, kMaxQuoted)).append(">: ").append(what);
  std::replace_if(message.begin(), message.end(), isControl, '?');
  return message;
}

tl::unexpected<Error> XmlSource::failAt(const pugi::xml_node& node, std::string_view what) const {
  return fail(describeAt(node, what));
}

pugi::xml_node XmlSource::findId(std::string_view id) const {
  const auto found = document_->byId.find(id);
  return found == document_->byId.end() ? pugi::xml_node() : found->second;
}

Result<pugi::xml_node> XmlSource::child(const pugi::xml_node& parent, const char* name,
                                        std::string_view purpose) const {
  const pugi::xml_node found = parent.child(name);
  if (!found) {
    return failAt(parent, "has no <" + std::string(name) + ">; " + std::string(purpose));
  }
  return found;
}

Result<pugi::xml_node> XmlSource::resolve(const pugi::xml_node& node, const char* attribute,
                                          const char* kind) const {
  const pugi::xml_attribute link = node.attribute(attribute);
  const std::string_view url = link.value();
  if (!link || url.empty()) {
    return fail("has no " + std::string(attribute) + " that names a <" + kind + ">");
  }
  const std::string what = std::string(attribute) + " " + inQuotes(url);
  if (url.front() != '#') {
    return fail(what + " points outside this file; put the <" + kind + "> into it");
  }
  const pugi::xml_node found = findId(url.substr(1));
  if (!found) {
    return fail(what + " names nothing in this file");
  }
  if (std::string_view(found.name()) != kind) {
    return fail(what + " should name a <" + kind + ">, but that is a <" +
                std::string(found.name()).substr(0, kMaxQuoted) + ">");
  }
  return found;
}

Result<pugi::xml_node> XmlSource::follow(const pugi::xml_node& node, const char* attribute,
                                         const char* kind) const {
  const auto found = resolve(node, attribute, kind);
  if (!found) {
    return failAt(node, found.error().message);
  }
  return found;
}

}  // namespace scatter::io
