// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/FilmFile.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
}

#include <opencv2/imgproc.hpp>
#include <utility>

namespace kelpie::picture {
namespace {

// x264's "veryfast" at this quality takes 5 ms and 2 KB a frame where its default
// ("medium", 23) took 28 ms and 14 KB; writing stays sharp.
constexpr const char* kPreset = "veryfast";
constexpr const char* kQuality = "30";
constexpr int kKeyFrames = 60;  // at least every two seconds, so that a player can seek

struct FreeCodec {
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
};
struct FreeFrame {
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreePacket {
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
struct FreeFormat {
  void operator()(AVFormatContext* format) const {
    if (format->pb != nullptr) avio_closep(&format->pb);
    avformat_free_context(format);
  }
};

std::string wordsFor(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> words{};
  av_strerror(error, words.data(), words.size());
  return words.data();
}

}  // namespace

struct FilmFile::Encoder {
  std::string path;
  std::unique_ptr<AVFormatContext, FreeFormat> format;
  std::unique_ptr<AVCodecContext, FreeCodec> codec;
  std::unique_ptr<AVFrame, FreeFrame> frame;
  std::unique_ptr<AVPacket, FreePacket> packet{av_packet_alloc()};
  AVStream* stream = nullptr;
  cv::Mat planes;  // Y, U and V of the frame, one below the other

  Status check(int result) const {
    if (result >= 0) return Done{};
    return Error{"the film cannot be written: " + wordsFor(result)};
  }
  int openCodec(cv::Size size, int framesPerSecond);
  int openFile();
  int encode(const AVFrame* next);  // nullptr: no more frames
};

int FilmFile::Encoder::openCodec(cv::Size size, int framesPerSecond) {
  const AVCodec* x264 = avcodec_find_encoder_by_name("libx264");
  if (x264 == nullptr) return AVERROR_ENCODER_NOT_FOUND;
  codec.reset(avcodec_alloc_context3(x264));
  codec->width = size.width;
  codec->height = size.height;
  codec->pix_fmt = AV_PIX_FMT_YUV420P;
  codec->time_base = {1, framesPerSecond};
  codec->framerate = {framesPerSecond, 1};
  codec->gop_size = kKeyFrames;
  codec->thread_count = 0;
  codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  av_opt_set(codec->priv_data, "preset", kPreset, 0);
  av_opt_set(codec->priv_data, "crf", kQuality, 0);
  return avcodec_open2(codec.get(), x264, nullptr);
}

int FilmFile::Encoder::openFile() {
  AVFormatContext* made = nullptr;
  // With "file:" a name with a colon is not taken for an address.
  const std::string url = "file:" + path;
  int result = avformat_alloc_output_context2(&made, nullptr, "mp4", url.c_str());
  if (result < 0) return result;
  format.reset(made);
  stream = avformat_new_stream(made, nullptr);
  stream->time_base = codec->time_base;
  result = avcodec_parameters_from_context(stream->codecpar, codec.get());
  if (result >= 0) result = avio_open(&made->pb, url.c_str(), AVIO_FLAG_WRITE);
  return result < 0 ? result : avformat_write_header(made, nullptr);
}

int FilmFile::Encoder::encode(const AVFrame* next) {
  int result = avcodec_send_frame(codec.get(), next);
  while (result >= 0) {
    result = avcodec_receive_packet(codec.get(), packet.get());
    if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return 0;
    if (result < 0) return result;
    av_packet_rescale_ts(packet.get(), codec->time_base, stream->time_base);
    packet->stream_index = stream->index;
    result = av_interleaved_write_frame(format.get(), packet.get());
  }
  return result;
}

Expected<FilmFile> FilmFile::create(const std::string& path, cv::Size size, int framesPerSecond) {
  av_log_set_level(AV_LOG_QUIET);  // what fails is reported by us, in one line
  auto encoder = std::make_unique<Encoder>();
  encoder->path = path;
  int result = encoder->openCodec(size, framesPerSecond);
  if (result >= 0) result = encoder->openFile();
  encoder->frame.reset(av_frame_alloc());
  AVFrame& frame = *encoder->frame;
  frame.format = AV_PIX_FMT_YUV420P;
  frame.width = size.width;
  frame.height = size.height;
  const Status opened = encoder->check(result);
  if (!opened) return Error{opened.error()};
  return FilmFile(std::move(encoder));
}

FilmFile::FilmFile(std::unique_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
FilmFile::FilmFile(FilmFile&&) noexcept = default;
FilmFile& FilmFile::operator=(FilmFile&&) noexcept = default;
FilmFile::~FilmFile() = default;

Status FilmFile::add(const cv::Mat& picture) {
  AVFrame& frame = *encoder_->frame;
  const std::int64_t number = encoder_->planes.empty() ? 0 : frame.pts + 1;
  cv::cvtColor(picture, encoder_->planes, cv::COLOR_BGR2YUV_I420);
  const int pixels = frame.width * frame.height;
  frame.data[0] = encoder_->planes.data;
  frame.data[1] = frame.data[0] + pixels;
  frame.data[2] = frame.data[1] + pixels / 4;
  frame.linesize[0] = frame.width;
  frame.linesize[1] = frame.linesize[2] = frame.width / 2;
  frame.pts = number;
  return encoder_->check(encoder_->encode(&frame));
}

Status FilmFile::close() {
  int result = encoder_->encode(nullptr);
  const int ended = av_write_trailer(encoder_->format.get());
  if (result >= 0) result = ended;
  const int closed = avio_closep(&encoder_->format->pb);
  return encoder_->check(result >= 0 ? closed : result);
}

}  // namespace kelpie::picture
