% octave_reads.m -- as Octave reads them, a table has the same numbers in its CSV and its NPY file. NAME
% in the environment is the path of both without the ending.
name = getenv("NAME");
table = dlmread([name ".csv"], ",", 1, 0);
id = fopen([name ".npy"], "r", "ieee-le");
head = fread(id, 10, "uint8");
assert(char(head(2:6)'), "NUMPY");
text = fread(id, head(9) + 256 * head(10), "char=>char")';
assert(mod(ftell(id), 64), 0);
type = regexp(text, "'descr': '(<[fi]8)'", "tokens"){1}{1};
shape = str2num(["[" regexp(text, "'shape': \\(([^)]*)\\)", "tokens"){1}{1} "]"]);
a = fread(id, Inf, {"double", "int64=>double"}{1 + strcmp(type, "<i8")});
fclose(id);
assert(prod(shape), numel(a));
assert(shape(end), columns(table) - 2);
assert(a, reshape(table(:, 3:end)', [], 1));
