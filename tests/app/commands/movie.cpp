#include <catch2/catch.hpp>

#include "app/program.hpp"

using namespace vortree::test;

namespace {

const std::string circle = R"(
accuracy = 0.1
[flow]
reynolds = 40
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
dt = 0.04
end = 0.48
[output]
frames = 0.24
fields_every = 0.04
window = [-1.0, -1.0, 2.0, 1.0]
field_spacing = 0.05
)";

const std::string vortex = R"(
accuracy = 0.1
[flow]
nu = 1e-3
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
dt = 0.04
end = 0.4
[output]
frames = 0.04
)";

/// The folder r of a run without figures.
void run(const std::string& scene, const TemporaryFolder& in, const std::string& more = "") {
  const NoFigures quick(in);
  in.write("scene.toml", scene);
  REQUIRE(call("run scene.toml --out r " + more, in).code == 0);
}

/// Whether an ffmpeg is there; the launcher installs it.
bool has_ffmpeg(const TemporaryFolder& in) {
  if (shell("command -v ffmpeg", in).code == 0) return true;
  WARN("no ffmpeg: no movie is made");
  return false;
}

std::string stream_of(const std::string& video, const TemporaryFolder& in) {
  return shell(
             "ffprobe -v error -count_frames -of csv=p=0 -show_entries "
             "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames " +
                 video,
             in)
      .out;
}

bool left_parts(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".part") return true;
  return false;
}

/// A place for an ffmpeg that is none.
void fake_ffmpeg(const TemporaryFolder& in, const std::string& shell_script) {
  fs::create_directory(in / "bin");
  fs::permissions(in.write("bin/ffmpeg", "#!/bin/sh\n" + shell_script), fs::perms::owner_all);
}

}  // namespace

TEST_CASE("a movie has a frame for each picture, sides that are even, and comes with a small one") {
  const TemporaryFolder folder;
  if (!has_ffmpeg(folder)) return;
  run(circle, folder);
  const Outcome made = call("movie r --size 301 --fps 10 --streamlines", folder);
  CHECK(made.err == "");
  REQUIRE(made.code == 0);
  CHECK(made.out.starts_with("r/movie.mp4: 13 pictures of "));
  const std::string told = stream_of("r/movie.mp4", folder);
  CAPTURE(told);
  CHECK(told.starts_with("h264,"));
  CHECK(told.find(",300,yuv420p,10/1,13\n") != std::string::npos);
  CHECK(std::stoi(told.substr(5)) % 2 == 0);
  CHECK((fs::exists(folder / "r/movie.webp") || fs::exists(folder / "r/movie.gif")));
  CHECK(!left_parts(folder / "r"));
  const std::string video = text_of(folder / "r/movie.mp4");
  CHECK(video.find("moov") < video.find("mdat"));  // it plays while it is fetched
}

TEST_CASE("the flow moves in a movie, whatever is shown of it") {
  const TemporaryFolder folder;
  if (!has_ffmpeg(folder)) return;
  run(circle, folder);
  for (const std::string what : {"vorticity", "speed", "pressure"}) {
    REQUIRE(call("movie r --size 240 --out v.mp4 --what " + what, folder).code == 0);
    const Outcome differing = shell(
        "ffmpeg -v error -i v.mp4 -vf crop=iw/3:ih/4:iw/4:ih/5 -f framemd5 - | grep -v '#' | cut "
        "-d, -f6 | sort -u | wc -l",
        folder);
    CAPTURE(what);
    // a body set off at once has no pressure at t = 0
    CHECK(std::stoi(differing.out) == (what == "pressure" ? 12 : 13));
  }
}

TEST_CASE("blobs in free space make a movie of the frames, without pictures") {
  const TemporaryFolder folder;
  if (!has_ffmpeg(folder)) return;
  run(vortex, folder);
  REQUIRE(call("movie r --what blobs --size 240", folder).code == 0);
  CHECK(stream_of("r/movie.mp4", folder).ends_with(",yuv420p,25/1,11\n"));
  const Outcome refused = call("movie r --what blobs --streamlines", folder);
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--streamlines") != std::string::npos);
}

TEST_CASE("a movie of nothing is refused with what to set, and none is left") {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& arguments) {
    const Outcome refused = call(arguments, folder);
    CAPTURE(arguments, refused.err);
    CHECK(refused.code == 2);
    CHECK(refused.error_lines() == 1);
    return refused.err;
  };
  using Catch::Contains;
  CHECK_THAT(refusal("movie nowhere"), Contains("nowhere: no such folder"));
  fs::create_directory(folder / "empty");
  CHECK_THAT(refusal("movie empty"), Contains("no run has left frames.h5"));
  CHECK_THAT(refusal("movie empty --what sound"), Contains("sound"));
  CHECK_THAT(refusal("movie empty --fps 0"), Contains("--fps"));
  if (!has_ffmpeg(folder)) return;
  run(circle, folder, "output.fields_every=0.08");
  CHECK_THAT(refusal("movie r"), Contains("r: 7 pictures") && Contains("output.fields_every"));
  CHECK_THAT(refusal("movie r --what blobs"), Contains("3 frames") && Contains("output.frames"));
  CHECK_THAT(refusal("movie r --out movie.avi"), Contains(".mp4"));
  CHECK_THAT(refusal("movie r --out none/movie.mp4"), Contains("no such folder"));
  const std::string resumed = "output.fields_every=0.04 time.end=0.6 --resume";
  run(circle, folder, resumed + " 'output.window=[-1.0,-1.0,2.5,1.0]'");
  CHECK_THAT(refusal("movie r"), Contains("several grids"));
  fs::remove(folder / "r/fields.h5");
  CHECK_THAT(refusal("movie r"), Contains("no pictures") && Contains("output.fields_every"));
  CHECK(!fs::exists(folder / "r/movie.mp4"));
}

TEST_CASE("without ffmpeg one line says which package is missing; one that breaks leaves nothing") {
  const TemporaryFolder folder;
  run(circle, folder);
  fs::create_directory(folder / "none");
  const auto with = [&](const std::string& path) {
    return shell("PATH=" + path + " '" VORTREE_PROGRAM "' movie r", folder);
  };
  const Outcome missing = with("none");
  CHECK(missing.code == 2);
  CHECK(missing.error_lines() == 1);
  CHECK(missing.err.find("apt-get install ffmpeg") != std::string::npos);

  fake_ffmpeg(folder, "echo ' V....D mpeg4 MPEG-4'");
  const Outcome poor = with("bin:$PATH");
  CHECK(poor.code == 2);
  CHECK(poor.err.find("libx264") != std::string::npos);

  fake_ffmpeg(folder,
              "case $* in *-encoders) echo ' V....D libx264 H.264';; *)\n"
              "for out; do :; done; echo half >\"$out\"; echo 'disk full' >&2; exit 1;; esac");
  const Outcome broken = with("bin:$PATH");
  CHECK(broken.code == 1);
  CHECK(broken.err == "vortree: ffmpeg: disk full\n");
  CHECK(!fs::exists(folder / "r/movie.mp4"));
  CHECK(!left_parts(folder / "r"));
}

TEST_CASE("a movie is refused where a link leads to the frames, of whatever run") {
  const TemporaryFolder folder;
  run(circle, folder);
  const std::string frames = text_of(folder / "r/frames.h5");
  fs::copy(folder / "r", folder / "copy");
  fs::create_symlink("r/frames.h5", folder / "link.mp4");
  for (const std::string of : {"r", "copy"}) {
    const Outcome refused = call("movie " + of + " --out link.mp4", folder);
    CAPTURE(of, refused.err);
    CHECK(refused.code == 2);
    CHECK(refused.err.find("the output would destroy it") != std::string::npos);
  }
  if (has_ffmpeg(folder)) {  // nor the small one beside it
    for (const char* small : {"m.webp", "m.gif"}) fs::create_symlink("r/frames.h5", folder / small);
    const Outcome refused = call("movie r --out m.mp4", folder);
    CHECK(refused.code == 2);
    CHECK(refused.err.find("the output would destroy it") != std::string::npos);
  }
  CHECK((text_of(folder / "r/frames.h5") == frames));
}

TEST_CASE("an older movie goes with the run that it shows, and is no figure") {
  const TemporaryFolder folder;
  run(circle, folder);
  folder.write("r/movie.mp4", "of another flow");
  run(circle, folder, "--overwrite");
  CHECK(!fs::exists(folder / "r/movie.mp4"));
  CHECK(call("plot r", folder).out.find("movie") == std::string::npos);
}
