// Many records of the same size with stable addresses.
//
// Records live in segments of about a mebibyte; growing adds a segment and moves nothing, so that there is
// neither a copy nor a peak of memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

namespace praxis {

/// Records of `record_words` 32-bit words, numbered from 0. At most 2^32 - 2 records; std::bad_alloc beyond.
class RecordPool {
  public:
    explicit RecordPool(std::size_t record_words)
        : stride_(record_words),
          shift_(static_cast<std::uint32_t>(std::bit_width(kSegmentWords / (record_words + 1)))),
          mask_((std::uint32_t{1} << shift_) - 1) {
        grow();
    }

    std::uint32_t size() const { return size_; }
    std::size_t stride() const { return stride_; }
    std::uint32_t* operator[](std::uint32_t i) {
        return segments_[i >> shift_].get() + (i & mask_) * stride_;
    }
    const std::uint32_t* operator[](std::uint32_t i) const {
        return segments_[i >> shift_].get() + (i & mask_) * stride_;
    }

    /// Room for the record that the next `commit` adds; its content is unspecified.
    std::uint32_t* next() { return (*this)[size_]; }
    /// Adds the record written at `next()`. The pool is unchanged if it throws.
    void commit() {
        if (((size_ + 1) & mask_) == 0) grow();
        ++size_;
    }
    /// Bytes on the heap.
    std::size_t memory() const {
        return segments_.capacity() * sizeof(segments_[0]) + (segments_.size() << shift_) * stride_ * 4;
    }

  private:
    static constexpr std::size_t kSegmentWords = std::size_t{1} << 18;

    void grow() {
        if ((segments_.size() + 1) << shift_ > (std::size_t{1} << 32) - 2) throw std::bad_alloc();
        segments_.push_back(std::make_unique_for_overwrite<std::uint32_t[]>(stride_ << shift_));
    }

    std::size_t stride_;
    std::uint32_t shift_;
    std::uint32_t mask_;
    std::uint32_t size_ = 0;
    std::vector<std::unique_ptr<std::uint32_t[]>> segments_;
};

}  // namespace praxis
