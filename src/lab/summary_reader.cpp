#include "lab/summary_reader.h"

#include <scatter/io/file.h>

#include "lab/names.h"

#include <string>
#include <utility>

namespace scatter::lab {

namespace {

// Json throws where a key is missing or of another kind; readSummary() catches that.

LevelEventCounts eventCounts(const Json& json) {
  LevelEventCounts counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    json.at(nameOf(static_cast<LevelEventKind>(i))).get_to(counts[i]);
  }
  return counts;
}

FidelityStatistics fidelityOf(const Json& json) {
  FidelityStatistics fidelity;
  json.at("every").get_to(fidelity.every);
  json.at("samples").get_to(fidelity.samples);
  for (const Json& share : json.at("touching_by_level")) {
    fidelity.touchingByLevel.push_back(share.at("touching_pairs").get<std::uint64_t>());
  }
  const Json& overlaps = json.at("visible_overlap_pairs");
  overlaps.at("mean").get_to(fidelity.visibleOverlapMean);
  overlaps.at("peak").get_to(fidelity.visibleOverlapPeak);
  overlaps.at("per_100_touching").get_to(fidelity.visibleOverlapPer100);
  json.at("contact_gaps").get_to(fidelity.contactGaps);
  json.at("contact_gap_p95").get_to(fidelity.contactGapP95);
  json.at("contact_gap_max").get_to(fidelity.contactGapMax);
  json.at("length").get_to(fidelity.length);
  const Json& finest = json.at("finest_share");
  finest.at("mean").get_to(fidelity.finestShareMean);
  finest.at("worst").get_to(fidelity.finestShareWorst);
  finest.at("worst_frame").get_to(fidelity.finestShareWorstFrame);
  json.at("largest_jump").get_to(fidelity.largestJump);
  json.at("largest_jump_frame").get_to(fidelity.largestJumpFrame);
  const Json& impact = json.at("impact");
  impact.at("first_frame").get_to(fidelity.impactFrame);
  impact.at("finest_share").get_to(fidelity.impactFinestShare);
  impact.at("contact_gap_p95").get_to(fidelity.impactContactGapP95);
  impact.at("visible_overlaps_per_100_touching").get_to(fidelity.impactVisibleOverlapPer100);
  json.at("pile_radius").get_to(fidelity.pileRadius);
  json.at("kinetic_energy_last_100_mean").get_to(fidelity.kineticEnergyEnd);
  return fidelity;
}

CollisionMemory memoryOf(const Json& json) {
  CollisionMemory memory;
  json.at("pairs").get_to(memory.pairs);
  json.at("child_pairs").get_to(memory.childPairs);
  json.at("pair_bytes").get_to(memory.pairBytes);
  json.at("child_pair_bytes").get_to(memory.childPairBytes);
  json.at("body_bytes").get_to(memory.bodyBytes);
  json.at("part_bytes").get_to(memory.partBytes);
  return memory;
}

ContactCheck contactCheckOf(const Json& json) {
  ContactCheck check;
  json.at("frames_verified").get_to(check.steps);
  json.at("child_pairs").get_to(check.childPairs);
  json.at("expected").get_to(check.expected);
  json.at("missed").get_to(check.missed);
  json.at("extra").get_to(check.extra);
  json.at("doubtful").get_to(check.doubtful);
  for (const Json& miss : json.at("first_missed")) {
    FrameMiss read;
    miss.at("frame").get_to(read.frame);
    miss.at("body_a").get_to(read.contact.bodyA);
    miss.at("part_a").get_to(read.contact.childA);
    miss.at("body_b").get_to(read.contact.bodyB);
    miss.at("part_b").get_to(read.contact.childB);
    miss.at("distance").get_to(read.contact.distance);
    check.firstMissed.push_back(read);
  }
  return check;
}

void readParts(const Json& json, Summary& summary) {
  json.at("engine").get_to(summary.engine);
  summary.levelEvents = eventCounts(json.at("level_events"));
  summary.levelEventsByPolicy.clear();
  for (const auto& [policy, counts] : json.at("level_events_by_policy").items()) {
    summary.levelEventsByPolicy[policy] = eventCounts(counts);
  }
  if (json.contains("fidelity")) {
    summary.fidelity = fidelityOf(json["fidelity"]);
  }
  if (json.contains("collision_memory")) {
    summary.collisionMemory = memoryOf(json["collision_memory"]);
  }
  if (json.contains("contact_check")) {
    summary.contactCheck = contactCheckOf(json["contact_check"]);
  }
}

}  // namespace

Result<Json> readJson(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) {
    return tl::unexpected(text.error());
  }
  Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded()) {
    return fail(file.string() + " is not a JSON file; remove it");
  }
  return json;
}

Result<void> readSummary(const Json& json, const std::filesystem::path& file, Summary& summary) {
  try {
    readParts(json, summary);
  } catch (const Json::exception&) {
    return fail(file.string() + " is not a summary that this program has written; remove it to run it again");
  }
  return {};
}

}  // namespace scatter::lab
