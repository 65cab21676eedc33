#pragma once
// What the solver wrote down step by step (DIR/history.csv): one column a quantity, in SI.

#include <map>
#include <string>
#include <vector>

namespace tektite {

class History {
 public:
  /// Reads the table; the last line of a run that was killed while writing it (no line end) is left out.
  /// Throws InputError with file and line where a row does not fit the header or holds no number.
  static History read(const std::string& path);

  bool has(const std::string& column) const { return columns_.contains(column); }
  /// The values of a column, row after row; throws RunError, naming what there is, where the column is missing.
  const std::vector<double>& column(const std::string& name) const;
  /// Names in the order of the file, without the columns of words.
  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return rows_; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace tektite
