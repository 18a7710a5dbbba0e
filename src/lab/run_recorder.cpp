#include "lab/run_recorder.h"

#include <scatter/lab/cpu_time.h>
#include <scatter/lab/environment.h>

#include <system_error>
#include <utility>

#include "lab/names.h"

namespace scatter::lab {

RecordingInfo recordingInfo(const SceneRun& run, bool contacts) {
  const RunOptions& options = run.options();
  const BuildInfo build = buildInfo();
  const MachineInfo machine = machineInfo();
  RecordingInfo info;
  info.scene = options.scene;
  info.label = options.label;
  info.engine = run.world().physics().engine();
  info.seed = options.seed.value_or(1);
  info.framesAsked = static_cast<std::uint64_t>(options.frames);
  info.stepSeconds = kStepSeconds;
  info.channels = recordedChannels(run.data());
  info.notes = {{"build", build.version + " " + build.commit + " " + build.buildType + ", " + build.compiler},
                {"machine", machine.cpu},
                {"world", nameOf(options.physics.world)}};
  if (contacts) info.notes["contacts"] = "contact points and levels of pairs";
  return info;
}

Result<std::unique_ptr<RunRecorder>> RunRecorder::create(const RecordOptions& options, const SceneRun& run) {
  auto writer = RecordingWriter::create(options.file, recordingInfo(run, options.contacts));
  if (!writer) return tl::unexpected(writer.error());
  std::unique_ptr<RunRecorder> recorder(new RunRecorder(options, std::move(*writer)));
  recorder->add(run);
  return recorder;
}

RunRecorder::RunRecorder(const RecordOptions& options, std::unique_ptr<RecordingWriter> writer)
    : options_(options), sampler_(options.contacts), writer_(std::move(writer)) {
  cost_.file = options.file;
}

void RunRecorder::add(const SceneRun& run) {
  if (!cost_.failed.empty()) return;
  const double before = threadCpuSeconds();
  const double wallBefore = wallSeconds();
  sampler_.sample(run.world(), &run.data(), writer_->next());
  note(writer_->add());
  cost_.runSeconds += threadCpuSeconds() - before;
  cost_.wallSeconds += wallSeconds() - wallBefore;
  ++cost_.frames;
}

void RunRecorder::finish(const std::string& stopped) {
  if (cost_.failed.empty()) note(writer_->finish(stopped));
  cost_.writerSeconds = writer_->threadSeconds();
  cost_.movingBodies = sampler_.movingBodies();
  std::error_code error;
  const auto size = std::filesystem::file_size(options_.file, error);
  cost_.bytes = error ? 0 : size;
}

void RunRecorder::note(const Result<void>& written) {
  if (!written && cost_.failed.empty()) {
    cost_.failed = "the recording is not whole: " + written.error().message;
  }
}

}  // namespace scatter::lab
