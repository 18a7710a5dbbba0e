#include "lod/make_policy.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "text/nearest_name.h"

namespace scatter::lod {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";
constexpr std::size_t kLongestQuote = 40;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

/// In quotes, on one line and not long, whatever it is.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text.substr(0, kLongestQuote)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (text.size() > kLongestQuote ? "...\"" : "\"");
}

std::string number(double value) {
  std::array<char, 48> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%g", value);
  return buffer.data();
}

/// What is known, and what may have been meant. Every known thing has a name.
template <class Known>
std::string suggestion(std::string_view name, std::span<const Known> known) {
  std::string list;
  std::vector<std::string_view> names;
  for (const Known& one : known) {
    list += (list.empty() ? "" : ", ") + std::string(one.name);
    names.emplace_back(one.name);
  }
  const std::string_view nearest = nearestName(name, names);
  const std::string meant = nearest.empty() ? "" : "did you mean " + quoted(nearest) + "? ";
  return meant + "known: " + list;
}

template <class Known>
std::optional<std::size_t> indexOf(std::string_view name, std::span<const Known> known) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const Known& k) { return k.name == name; });
  if (found == known.end()) return std::nullopt;
  return static_cast<std::size_t>(found - known.begin());
}

Result<double> parseValue(const std::string& where, const ParameterInfo& parameter, std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return fail(where + quoted(text) + " is not a number");
  const bool isInRange = value >= parameter.least && value <= parameter.most;
  if (!isInRange) {
    const std::string unit = parameter.unit.empty() ? "" : " " + std::string(parameter.unit);
    return fail(where + quoted(text) + " is out of range; it can be " + number(parameter.least) + " to " +
                number(parameter.most) + unit);
  }
  if (parameter.whole && std::floor(value) != value)
    return fail(where + quoted(text) + " is not a whole number");
  return value;
}

/// Reads "name=value" into its place.
Result<void> readParameter(const PolicyInfo& policy, std::string_view text, std::vector<double>& values,
                           std::vector<bool>& isSet) {
  const std::string where = "policy " + quoted(policy.name) + ": ";
  if (policy.parameters.empty()) return fail(where + "it has no parameters; leave out " + quoted(text));
  const std::size_t sign = text.find('=');
  const std::string_view name = trimmed(text.substr(0, sign));
  const auto index = indexOf(name, policy.parameters);
  if (!index) {
    return fail(where + "no parameter is called " + quoted(name) + "; " +
                suggestion(name, policy.parameters));
  }
  const ParameterInfo& parameter = policy.parameters[*index];
  if (sign == std::string_view::npos) {
    return fail(where + quoted(name) + " has no value; write " + std::string(name) + "=" +
                number(parameter.standard));
  }
  if (isSet[*index]) return fail(where + quoted(name) + " is given twice; leave one out");
  const auto value = parseValue(where + quoted(name) + ": ", parameter, trimmed(text.substr(sign + 1)));
  if (!value) return tl::unexpected(value.error());
  values[*index] = *value;
  isSet[*index] = true;
  return {};
}

std::vector<double> standardValues(const PolicyInfo& policy) {
  std::vector<double> values;
  for (const ParameterInfo& parameter : policy.parameters) values.push_back(parameter.standard);
  return values;
}

/// The values of all parameters, in their order.
Result<std::vector<double>> readParameters(const PolicyInfo& policy, std::string_view text) {
  std::vector<double> values = standardValues(policy);
  std::vector<bool> isSet(values.size(), false);
  while (true) {
    const std::size_t comma = text.find(',');
    if (auto read = readParameter(policy, trimmed(text.substr(0, comma)), values, isSet); !read) {
      return tl::unexpected(read.error());
    }
    if (comma == std::string_view::npos) return values;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace

Result<std::unique_ptr<Policy>> makePolicy(std::string_view spec, const std::shared_ptr<Grouping>& grouping) {
  const std::size_t colon = spec.find(':');
  const std::string_view name = trimmed(spec.substr(0, colon));
  const auto index = indexOf(name, knownPolicies());
  if (!index) return fail("no policy is called " + quoted(name) + "; " + suggestion(name, knownPolicies()));

  const PolicyInfo& policy = knownPolicies()[*index];
  const auto values = colon == std::string_view::npos ? Result<std::vector<double>>(standardValues(policy))
                                                      : readParameters(policy, spec.substr(colon + 1));
  if (!values) return tl::unexpected(values.error());
  auto made = makeKnownPolicy(*index, *values, grouping);
  if (!made) return fail("policy " + quoted(name) + ": " + made.error().message);
  return made;
}

Result<std::unique_ptr<PolicyList>> makePolicyList(std::span<const std::string> specs) {
  if (specs.size() > PolicyList::kMost) {
    return fail(std::to_string(specs.size()) + " policies are too many; there can be " +
                std::to_string(PolicyList::kMost));
  }
  auto list = std::make_unique<PolicyList>();
  for (const std::string& spec : specs) {
    auto policy = makePolicy(spec, list->grouping());
    if (!policy) return tl::unexpected(policy.error());
    list->add(std::move(*policy));
  }
  return list;
}

}  // namespace scatter::lod
