// SPDX-License-Identifier: Apache-2.0
#include "horopter/image/image.hpp"

#include <fmt/format.h>
#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "horopter/base/error.hpp"
#include "horopter/base/file.hpp"
#include "horopter/image/mat.hpp"
#include "image_check.hpp"

namespace horopter {
namespace {

/// libjpeg's warnings are kept: most of them mean that pixels were made up.
struct JpegErrors {
  jpeg_error_mgr manager;
  std::jmp_buf escape;
  char message[JMSG_LENGTH_MAX] = "";
  bool damaged = false;
};

void on_jpeg_error(j_common_ptr info) {
  auto* errors = reinterpret_cast<JpegErrors*>(info->err);
  info->err->format_message(info, errors->message);
  std::longjmp(errors->escape, 1);
}

void on_jpeg_message(j_common_ptr info, int level) {
  if (level >= 0) return;
  auto* errors = reinterpret_cast<JpegErrors*>(info->err);
  if (info->err->msg_code == JWRN_ADOBE_XFORM) return;
  if (!errors->damaged) info->err->format_message(info, errors->message);
  errors->damaged = true;
}

/// Decodes to luma (the Y of JFIF is that of Rec. 601), each side divided by `smaller`. False: `errors` says why; no
/// C++ object lives across the jump.
bool decode_jpeg_grey(std::span<const std::uint8_t> bytes, unsigned smaller, JpegErrors& errors, Image& image) {
  jpeg_decompress_struct info{};
  info.err = jpeg_std_error(&errors.manager);
  errors.manager.error_exit = on_jpeg_error;
  errors.manager.emit_message = on_jpeg_message;
  if (setjmp(errors.escape) != 0) {
    jpeg_destroy_decompress(&info);
    return false;
  }
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&info, TRUE);
  info.out_color_space = JCS_GRAYSCALE;
  info.scale_num = 1;
  info.scale_denom = smaller;
  jpeg_start_decompress(&info);
  image = Image(static_cast<int>(info.output_width), static_cast<int>(info.output_height));
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = image.pixels.data() + static_cast<std::size_t>(info.output_scanline) * image.width;
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  jpeg_destroy_decompress(&info);
  return !errors.damaged;
}

Image decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, unsigned smaller = 1) {
  JpegErrors errors;
  Image image;
  if (!decode_jpeg_grey(bytes, smaller, errors, image)) {
    throw FileError(name, "", fmt::format("damaged or truncated JPEG data ({})", errors.message),
                    "a complete JPEG, grey or colour");
  }
  return image;
}

Image decode_other(std::span<const std::uint8_t> bytes, const std::string& name) {
  cv::Mat decoded;
  try {
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::uint8_t*>(bytes.data()));
    decoded = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw FileError(name, "", "the image cannot be decoded (" + error.err + ")", "an undamaged 8-bit image");
  }
  if (decoded.empty()) throw FileError(name, "", "the image cannot be decoded", "an undamaged 8-bit image");
  if (decoded.depth() != CV_8U) {
    throw FileError(name, "", "more than 8 bits a sample", "an 8-bit image, grey or colour");
  }
  if (const int samples = decoded.channels(); samples != 1 && samples != 3 && samples != 4) {
    throw FileError(name, "", fmt::format("{} samples a pixel", samples), "1 (grey), 3 or 4 (colour)");
  }
  return grey_image(decoded);
}

}  // namespace

Image grey_image(const cv::Mat& pixels) {
  cv::Mat grey = pixels;
  if (pixels.channels() == 3) cv::cvtColor(pixels, grey, cv::COLOR_BGR2GRAY);
  if (pixels.channels() == 4) cv::cvtColor(pixels, grey, cv::COLOR_BGRA2GRAY);
  Image image(grey.cols, grey.rows);
  for (int y = 0; y < grey.rows; ++y) std::copy_n(grey.ptr(y), grey.cols, &image.at(0, y));
  return image;
}

Image decode_image(std::span<const std::uint8_t> bytes, const std::string& name) {
  const ImageFormat format = sniff_format(bytes);
  check_structure(bytes, format, name);
  return format == ImageFormat::jpeg ? decode_jpeg(bytes, name) : decode_other(bytes, name);
}

Image load_image(const std::filesystem::path& path) {
  return decode_image(read_file(path, "an image (PNG, JPEG, PNM, BMP or TIFF)"), path.string());
}

void check_jpeg_packet(std::span<const std::uint8_t> bytes, const std::string& name) {
  constexpr unsigned kSmallest = 8;  // all of the data is read, and hardly a pixel made
  for (const auto& image : jpegs_in(bytes, name)) decode_jpeg(image, name, kSmallest);
}

Image field_of(const Image& image, int parity) {
  Image field(image.width, (image.height + 1 - parity) / 2);
  for (int y = 0; y < field.height; ++y) {
    const auto row = image.row(2 * y + parity);
    std::copy(row.begin(), row.end(), &field.at(0, y));
  }
  return field;
}

}  // namespace horopter
