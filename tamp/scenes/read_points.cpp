#include "tamp/scenes/read_points.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

constexpr std::size_t kMostPoints = 50'000'000;

/// A number of a binary record.
struct Field {
    std::size_t offset = 0;
    std::size_t size = 0;  ///< 4 or 8: float or double; 0: not there
};

class Reader {
  public:
    explicit Reader(const Source& file) : file_(file), rest_(file.text) {}

    std::vector<Vector3> read() {
        if (rest_.starts_with("ply\n") || rest_.starts_with("ply\r\n")) {
            read_ply();
        } else if (is_pcd()) {
            read_pcd();
        } else {
            read_text();
        }
        return std::move(points_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { fail_unplaced(file_.name + ": " + what); }
    [[noreturn]] void fail_here(const std::string& what) const {
        fail_unplaced(file_.name + ':' + std::to_string(line_number_) + ": " + what);
    }

    bool is_pcd() const {
        const std::string_view start = rest_.substr(0, 400);
        return start.starts_with("# .PCD") || start.starts_with("VERSION") || start.starts_with("FIELDS");
    }

    std::string_view line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view result = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++line_number_;
        if (result.ends_with('\r')) result.remove_suffix(1);
        return result;
    }

    static std::vector<std::string_view> words(std::string_view text, std::size_t most) {
        constexpr std::string_view kBetween = " \t,;";
        std::vector<std::string_view> result;
        while (result.size() < most) {
            const std::size_t begin = text.find_first_not_of(kBetween);
            if (begin == std::string_view::npos) break;
            text.remove_prefix(begin);
            const std::size_t end = std::min(text.find_first_of(kBetween), text.size());
            result.push_back(text.substr(0, end));
            text.remove_prefix(end);
        }
        return result;
    }

    template <class T>
    static bool to_number(std::string_view word, T& value) {
        if (word.starts_with('+')) word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        return error == std::errc() && end == word.data() + word.size();
    }

    std::size_t count_of(std::string_view word, const char* what) const {
        std::size_t count = 0;
        if (!to_number(word, count) || count > kMostPoints) {
            fail_here(std::string(what) + " must be a number up to 50 million, not " + quote(word));
        }
        return count;
    }

    void add(const Vector3& point) {
        if (points_.size() >= kMostPoints) fail("has more than 50 million points");
        if (point.allFinite()) points_.push_back(point);
    }

    /// One point of a text; `columns` tells where x, y and z stand.
    void add_line(std::string_view text, const std::array<std::size_t, 3>& columns) {
        const std::vector<std::string_view> numbers = words(text, *std::ranges::max_element(columns) + 1);
        Vector3 point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (columns[axis] >= numbers.size()) fail_here("a point needs three numbers");
            if (!to_number(numbers[columns[axis]], point[static_cast<Eigen::Index>(axis)])) {
                fail_here(quote(numbers[columns[axis]]) + " is no number");
            }
        }
        add(point);
    }

    void read_text() {
        std::array<std::size_t, 3> columns = {0, 1, 2};
        bool first = true;
        while (!rest_.empty()) {
            const std::string_view text = line();
            const std::vector<std::string_view> start = words(text, 64);
            if (start.empty() || start[0].starts_with('#') || start[0].starts_with("//")) continue;
            double number = 0;
            if (first && !to_number(start[0], number)) {
                columns = columns_of(start);
            } else {
                add_line(text, columns);
            }
            first = false;
        }
    }

    std::array<std::size_t, 3> columns_of(const std::vector<std::string_view>& names) const {
        std::array<std::size_t, 3> columns = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string_view wanted = std::string_view("xyz").substr(axis, 1);
            const auto found = std::ranges::find_if(names, [&](std::string_view name) {
                return name == wanted || (name.size() == 1 && name[0] == wanted[0] - 'a' + 'A');
            });
            if (found == names.end()) fail_here("there is no column " + quote(wanted));
            columns[axis] = static_cast<std::size_t>(found - names.begin());
        }
        return columns;
    }

    void read_records(std::size_t count, std::size_t size, const std::array<Field, 3>& fields) {
        if (size == 0 || rest_.size() / size < count) fail("ends before its last point");
        points_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            Vector3 point;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const char* at = rest_.data() + i * size + fields[axis].offset;
                double& coordinate = point[static_cast<Eigen::Index>(axis)];
                if (fields[axis].size == sizeof(double)) {
                    std::memcpy(&coordinate, at, sizeof(double));
                } else {
                    float value = 0;
                    std::memcpy(&value, at, sizeof(float));
                    coordinate = static_cast<double>(value);
                }
            }
            add(point);
        }
    }

    void read_pcd() {
        std::vector<std::string> names;
        std::vector<std::size_t> sizes;
        std::vector<std::size_t> counts;
        std::string types;
        std::size_t points = 0;
        std::string format;
        while (format.empty()) {
            if (rest_.empty()) fail("ends within its header");
            const std::vector<std::string_view> parts = words(line(), 1000);
            if (parts.empty() || parts[0].starts_with('#')) continue;
            const auto rest = std::vector<std::string_view>(parts.begin() + 1, parts.end());
            const auto numbers = [&] {
                std::vector<std::size_t> values;
                for (const std::string_view word : rest) values.push_back(count_of(word, "a size"));
                return values;
            };
            if (parts[0] == "FIELDS") names.assign(rest.begin(), rest.end());
            if (parts[0] == "SIZE") sizes = numbers();
            if (parts[0] == "COUNT") counts = numbers();
            if (parts[0] == "TYPE") {
                for (const std::string_view type : rest) types += type[0];
            }
            if (parts[0] == "POINTS" && !rest.empty()) points = count_of(rest[0], "POINTS");
            if (parts[0] == "DATA" && !rest.empty()) format = rest[0];
        }
        if (counts.empty()) counts.assign(names.size(), 1);
        if (sizes.size() != names.size() || types.size() != names.size() || counts.size() != names.size()) {
            fail("must have as many SIZE, TYPE and COUNT as FIELDS");
        }
        std::array<Field, 3> fields = {};
        std::array<std::size_t, 3> columns = {};
        std::size_t offset = 0;
        std::size_t column = 0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (names[i] != std::string(1, static_cast<char>('x' + static_cast<int>(axis)))) continue;
                if (types[i] != 'F' || (sizes[i] != 4 && sizes[i] != 8) || counts[i] != 1) {
                    fail("must have x, y, z of TYPE F and SIZE 4 or 8");
                }
                fields[axis] = {offset, sizes[i]};
                columns[axis] = column;
            }
            offset += sizes[i] * counts[i];
            column += counts[i];
        }
        require_fields(fields);
        if (format == "binary") {
            read_records(points, offset, fields);
        } else if (format == "ascii") {
            for (std::size_t i = 0; i < points; ++i) {
                if (rest_.empty()) fail("ends before its last point");
                add_line(line(), columns);
            }
        } else {
            fail("is PCD of kind " + quote(format) + "; convert it to ascii or binary");
        }
    }

    void read_ply() {
        line();
        std::string format;
        std::size_t points = 0;
        std::size_t elements = 0;
        std::size_t size = 0;
        std::size_t column = 0;
        std::array<Field, 3> fields = {};
        std::array<std::size_t, 3> columns = {};
        while (true) {
            if (rest_.empty()) fail("ends within its header");
            const std::vector<std::string_view> parts = words(line(), 16);
            if (parts.empty() || parts[0] == "comment" || parts[0] == "obj_info") continue;
            if (parts[0] == "end_header") break;
            if (parts[0] == "format" && parts.size() > 1) format = parts[1];
            if (parts[0] == "element" && parts.size() > 2) {
                if (++elements == 1 && parts[1] != "vertex") fail_here("the first element must be 'vertex'");
                if (elements == 1) points = count_of(parts[2], "the number of vertices");
            }
            if (parts[0] != "property" || elements != 1 || parts.size() < 3) continue;
            const std::size_t width = ply_size(parts[1]);
            if (width == 0) fail_here("a vertex cannot have a property of kind " + quote(parts[1]));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (parts[2] != std::string(1, static_cast<char>('x' + static_cast<int>(axis)))) continue;
                if (!parts[1].starts_with("float") && parts[1] != "double") {
                    fail_here("x, y and z must be of kind float or double");
                }
                fields[axis] = {size, width};
                columns[axis] = column;
            }
            size += width;
            ++column;
        }
        require_fields(fields);
        if (format == "binary_little_endian") {
            read_records(points, size, fields);
        } else if (format == "ascii") {
            for (std::size_t i = 0; i < points; ++i) {
                if (rest_.empty()) fail("ends before its last point");
                add_line(line(), columns);
            }
        } else {
            fail("is PLY of kind " + quote(format) + "; convert it to ascii or binary_little_endian");
        }
    }

    static std::size_t ply_size(std::string_view kind) {
        if (kind == "char" || kind == "uchar" || kind == "int8" || kind == "uint8") return 1;
        if (kind == "short" || kind == "ushort" || kind == "int16" || kind == "uint16") return 2;
        if (kind == "int" || kind == "uint" || kind == "int32" || kind == "uint32") return 4;
        if (kind == "float" || kind == "float32") return 4;
        return kind == "double" || kind == "float64" ? 8 : 0;
    }

    void require_fields(const std::array<Field, 3>& fields) const {
        if (std::ranges::any_of(fields, [](const Field& field) { return field.size == 0; })) {
            fail("must have the fields x, y and z");
        }
    }

    const Source& file_;
    std::string_view rest_;
    std::size_t line_number_ = 0;
    std::vector<Vector3> points_;
};

}  // namespace

std::vector<Vector3> parse_points(const Source& file) {
    return Reader(file).read();
}

}  // namespace praxis::tamp
