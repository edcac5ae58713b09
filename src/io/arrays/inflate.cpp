#include "io/arrays/inflate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/frames/hdf5_inside.hpp"

#ifdef VORTREE_ZLIB
#include <zlib.h>
#endif

namespace vortree::io {

#ifdef VORTREE_ZLIB
namespace {

// deflate packs 258 bytes into two bits at best.
constexpr std::uint64_t closest_packed = 1032;

/// A stream of zlib's, ended with its scope.
class Inflation {
 public:
  Inflation() {
    if (inflateInit2(&stream_, -MAX_WBITS) != Z_OK) throw BadArray("zlib does not begin");
  }
  ~Inflation() { inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// Whether all of `packed` became all of `room`. Lengths of zlib are 32 bits wide.
  bool fills(std::string& room, std::string_view packed) {
    std::uint64_t taken = 0, given = 0;
    for (int status = Z_OK; status != Z_STREAM_END;) {
      const auto more = static_cast<uInt>(std::min<std::uint64_t>(packed.size() - taken, longest));
      const auto free = static_cast<uInt>(std::min<std::uint64_t>(room.size() - given, longest));
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
      stream_.next_out = reinterpret_cast<Bytef*>(room.data() + given);
      stream_.avail_in = more;
      stream_.avail_out = free;
      status = ::inflate(&stream_, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END) return false;  // nothing more came, too
      taken += more - stream_.avail_in;
      given += free - stream_.avail_out;
    }
    return taken == packed.size() && given == room.size();
  }

 private:
  static constexpr std::uint64_t longest = std::numeric_limits<uInt>::max();
  z_stream stream_{};
};

}  // namespace

std::string inflated(std::string_view packed, std::uint64_t size) {
  if (size / closest_packed > packed.size())
    throw BadArray(fmt::format("it claims to be {} bytes packed into {}; so close none is packed",
                               size, packed.size()));
  h5::require_room(size / sizeof(double), "it");
  std::string room(size, '\0');
  if (!Inflation().fills(room, packed))
    throw BadArray(
        fmt::format("it is damaged: {} packed bytes do not unpack to {}", packed.size(), size));
  return room;
}

#else

std::string inflated(std::string_view, std::uint64_t) {
  throw BadArray(
      "it is packed, and this program was built without zlib: numpy.savez, without \"compressed\", "
      "packs nothing");
}

#endif

}  // namespace vortree::io
