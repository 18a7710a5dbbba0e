#include <scatter/recording/export.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <scatter/io/file.h>
#include <zstd.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "io/temporary_folder.h"
#include "recording/bytes.h"
#include "recording/samples.h"

namespace scatter {
namespace {

using nlohmann::json;
using recording::ByteReader;

class ExportTest : public testing::Test {
 protected:
  ExportTest() {
    test::writeRecording(folder / "run.rec", samples, 10);
    run = Recording::open(folder / "run.rec").value();
  }

  test::TemporaryFolder folder;
  std::vector<FrameSample> samples = test::sampleFrames(60);
  std::unique_ptr<Recording> run;
};

/// The numbers of an accessor of a .glb file.
class Glb {
 public:
  explicit Glb(const std::string& bytes) {
    ByteReader in(bytes);
    EXPECT_EQ(in.take(4), "glTF");
    EXPECT_EQ(in.fixed<std::uint32_t>(), 2U);
    EXPECT_EQ(in.fixed<std::uint32_t>(), bytes.size());
    const auto size = in.fixed<std::uint32_t>();
    EXPECT_EQ(in.take(4), "JSON");
    root = json::parse(in.take(size));
    in.take(8);
    data = in.take(in.left());
  }

  [[nodiscard]] std::vector<float> numbers(std::size_t accessor) const {
    const json& what = root["accessors"][accessor];
    const json& view = root["bufferViews"][what["bufferView"].get<std::size_t>()];
    std::vector<float> numbers(view["byteLength"].get<std::size_t>() / sizeof(float));
    std::memcpy(numbers.data(), data.data() + view.value("byteOffset", std::size_t{0}),
                numbers.size() * sizeof(float));
    return numbers;
  }

  /// Times and values of what is animated of a node; empty if it is not.
  [[nodiscard]] std::pair<std::vector<float>, std::vector<float>> animated(const std::string& name,
                                                                           const std::string& path) const {
    const json& animation = root["animations"][0];
    for (const json& channel : animation["channels"]) {
      const json& target = channel["target"];
      if (root["nodes"][target["node"].get<std::size_t>()]["name"] != name || target["path"] != path)
        continue;
      const json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      return {numbers(sampler["input"]), numbers(sampler["output"])};
    }
    return {};
  }

  json root;
  std::string data;
};

TEST_F(ExportTest, AnAnimationHasEveryBodyWhereItWas) {
  const auto counts = writeGltfAnimation(*run, {.first = 10, .last = 59, .step = 7}, folder / "run.glb");
  ASSERT_TRUE(counts) << counts.error().message;
  EXPECT_EQ(counts->frames, 8U);
  EXPECT_EQ(counts->bodies, 9U);
  const Glb glb(readFile(folder / "run.glb").value());
  EXPECT_EQ(counts->bytes, std::filesystem::file_size(folder / "run.glb"));
  EXPECT_FALSE(glb.root.contains("extensionsUsed"));
  const auto [times, positions] = glb.animated("body-5", "translation");
  const auto [turnTimes, turns] = glb.animated("body-5", "rotation");
  ASSERT_EQ(times.size(), 8U);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Transform& pose = samples[10 + 7 * i].bodies[5 - (10 + 7 * i >= 40 ? 1 : 0)].pose;
    EXPECT_NEAR(times[i], 7.0F * static_cast<float>(i) / 60.0F, 1e-5F);
    EXPECT_NEAR(positions[3 * i + 2], pose.position.z, kRecordedMetres);
    const Quat turn(turns[4 * i + 3], turns[4 * i], turns[4 * i + 1], turns[4 * i + 2]);
    EXPECT_NEAR(std::abs(glm::dot(turn, pose.rotation)), 1.0F, 1e-5F);
  }
}

TEST_F(ExportTest, BodiesThatRestHaveNoKeysAndThoseThatComeAndGoAreHidden) {
  ASSERT_TRUE(writeGltfAnimation(*run, {.first = 0, .last = 59}, folder / "run.gltf"));
  ASSERT_TRUE(writeGltfAnimation(*run, {.first = 0, .last = 59}, folder / "run.glb"));
  EXPECT_TRUE(json::accept(readFile(folder / "run.gltf").value()));
  const Glb glb(readFile(folder / "run.glb").value());
  EXPECT_TRUE(glb.animated("body-2", "translation").first.empty());
  // It sleeps from frame 30 on.
  EXPECT_EQ(glb.animated("body-1", "translation").first.size(), 31U);
  const auto [times, sizes] = glb.animated("body-3", "scale");
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(sizes[0], 1.0F);
  EXPECT_NEAR(times[1], 40.0F / 60.0F, 1e-5F);
  EXPECT_EQ(sizes[3], 0.0F);
  EXPECT_NEAR(glb.animated("body-8", "scale").first[1], 25.0F / 60.0F, 1e-5F);
  // Bodies of a model share its mesh.
  EXPECT_EQ(glb.root["nodes"][0]["mesh"], glb.root["nodes"][3]["mesh"]);
}

// As viewers go from one key to the next.
TEST_F(ExportTest, ABodyThatRestsAndWakesTurnsTheShortWay) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float angle = 2.5F * static_cast<float>(i / 3);
    for (SampledBody& body : samples[i].bodies) {
      body.pose.position = {0.0F, 0.0F, 0.0F};
      body.pose.rotation = glm::angleAxis(angle, Vec3(0.0F, 1.0F, 0.0F));
    }
  }
  test::writeRecording(folder / "wakes.rec", samples, 10);
  const auto wakes = Recording::open(folder / "wakes.rec").value();
  ASSERT_TRUE(writeGltfAnimation(*wakes, {.first = 0, .last = 59}, folder / "wakes.glb"));
  const Glb glb(readFile(folder / "wakes.glb").value());
  for (const char* name : {"body-4", "body-5"}) {
    const auto turns = glb.animated(name, "rotation").second;
    ASSERT_GE(turns.size(), std::size_t{4 * 30}) << name;
    for (std::size_t i = 4; i < turns.size(); i += 4) {
      const float dot = turns[i] * turns[i - 4] + turns[i + 1] * turns[i - 3] + turns[i + 2] * turns[i - 2] +
                        turns[i + 3] * turns[i - 1];
      EXPECT_GE(dot, 0.0F) << name << ", key " << i / 4;
    }
  }
}

/// Reads what McapWriter writes, by the book.
class McapFile {
 public:
  struct Message {
    std::uint16_t channel = 0;
    std::uint64_t time = 0;
    json content;
  };

  explicit McapFile(std::string bytes) : bytes_(std::move(bytes)) {
    const std::string_view magic("\x89MCAP0\r\n", 8);
    EXPECT_EQ(std::string_view(bytes_).substr(0, 8), magic);
    EXPECT_EQ(std::string_view(bytes_).substr(bytes_.size() - 8), magic);
    ByteReader in(std::string_view(bytes_).substr(8, bytes_.size() - 16));
    while (in.left() > 0 && !in.failed()) read(in);
    EXPECT_FALSE(in.failed());
  }

  std::map<std::string, std::string> schemas;  ///< Of topics.
  std::map<std::string, std::uint16_t> channels;
  std::vector<Message> messages;
  std::uint64_t summary = 0;
  std::vector<std::uint64_t> chunkPlaces;

  [[nodiscard]] std::size_t count(const std::string& topic) const {
    return static_cast<std::size_t>(
        std::count_if(messages.begin(), messages.end(),
                      [&](const Message& message) { return message.channel == channels.at(topic); }));
  }

  [[nodiscard]] std::uint8_t opcodeAt(std::uint64_t place) const {
    return static_cast<std::uint8_t>(bytes_[static_cast<std::size_t>(place)]);
  }

 private:
  static std::string text(ByteReader& in) { return std::string(in.take(in.fixed<std::uint32_t>())); }

  void read(ByteReader& in) {
    const std::uint8_t opcode = in.byte();
    const auto size = in.fixed<std::uint64_t>();
    ByteReader record(in.take(static_cast<std::size_t>(size)));
    if (opcode == 0x03) {
      const auto number = record.fixed<std::uint16_t>();
      names_[number] = text(record);
      EXPECT_EQ(text(record), "jsonschema");
      EXPECT_TRUE(json::accept(text(record)));
    } else if (opcode == 0x04) {
      const auto number = record.fixed<std::uint16_t>();
      const auto schema = record.fixed<std::uint16_t>();
      const std::string topic = text(record);
      channels[topic] = number;
      schemas[topic] = names_.at(schema);
    } else if (opcode == 0x05) {
      Message message;
      message.channel = record.fixed<std::uint16_t>();
      record.fixed<std::uint32_t>();
      message.time = record.fixed<std::uint64_t>();
      record.fixed<std::uint64_t>();
      message.content = json::parse(record.take(record.left()));
      messages.push_back(std::move(message));
    } else if (opcode == 0x06) {
      readChunk(record);
    } else if (opcode == 0x08) {
      record.take(16);
      chunkPlaces.push_back(record.fixed<std::uint64_t>());
    } else if (opcode == 0x02) {
      summary = record.fixed<std::uint64_t>();
    }
  }

  void readChunk(ByteReader& record) {
    record.take(16);
    std::string raw(static_cast<std::size_t>(record.fixed<std::uint64_t>()), '\0');
    record.fixed<std::uint32_t>();
    EXPECT_EQ(text(record), "zstd");
    const std::string_view packed = record.take(static_cast<std::size_t>(record.fixed<std::uint64_t>()));
    ASSERT_EQ(ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size()), raw.size());
    ByteReader in(raw);
    while (in.left() > 0 && !in.failed()) read(in);
  }

  std::string bytes_;
  std::map<std::uint16_t, std::string> names_;
};

TEST_F(ExportTest, AnMcapFileHasBodiesTransformsDataAndEvents) {
  const auto counts = writeMcap(*run, {.first = 0, .last = 59}, folder / "run.mcap");
  ASSERT_TRUE(counts) << counts.error().message;
  EXPECT_EQ(counts->frames, 60U);
  EXPECT_EQ(counts->bodies, 9U);
  const McapFile file(readFile(folder / "run.mcap").value());
  EXPECT_EQ(file.schemas.at("/tf"), "foxglove.FrameTransforms");
  EXPECT_EQ(file.schemas.at("/scene"), "foxglove.SceneUpdate");
  EXPECT_EQ(file.schemas.at("/events"), "foxglove.Log");
  EXPECT_EQ(file.count("/tf"), 60U);
  EXPECT_EQ(file.count("/data"), 60U);
  // Anew when a body comes, and when one goes.
  EXPECT_EQ(file.count("/scene"), 3U);
  std::size_t events = 0;
  for (const FrameSample& sample : samples) events += sample.events.size();
  EXPECT_EQ(file.count("/events"), events);
  ASSERT_FALSE(file.chunkPlaces.empty());
  EXPECT_EQ(file.opcodeAt(file.chunkPlaces[0]), 0x06);
  EXPECT_EQ(file.opcodeAt(file.summary), 0x03);
  std::uint64_t last = 0;
  for (const auto& message : file.messages) {
    EXPECT_GE(message.time, last);
    last = message.time;
    if (message.channel != file.channels.at("/tf")) continue;
    const auto frame = static_cast<std::size_t>(std::llround(static_cast<double>(message.time) * 60e-9));
    const json& transform = message.content["transforms"][1];
    EXPECT_EQ(transform["child_frame_id"], "body-0#1");
    EXPECT_NEAR(transform["translation"]["y"].get<float>(), samples[frame].bodies[0].pose.position.y, 2e-4F);
  }
}

TEST_F(ExportTest, AFolderThatIsNotThereIsRefused) {
  for (const auto& write : {&writeGltfAnimation, &writeMcap}) {
    const auto written = (*write)(*run, {.first = 0, .last = 3}, folder / "none" / "run.out");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, testing::HasSubstr("run.out"));
  }
}

}  // namespace
}  // namespace scatter
