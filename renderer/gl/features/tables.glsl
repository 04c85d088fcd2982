// Tables, read by linear interpolation; each has one more entry than it uses. Where each begins is a uniform.
uniform samplerBuffer numbers;
uniform samplerBuffer colours;

float numberAt(int entry) { return texelFetch(numbers, entry).r; }
vec4 colourAt(int entry) { return texelFetch(colours, entry); }

float readTable(int table, float entry) {
    int whole = int(entry);
    return mix(numberAt(table + whole), numberAt(table + whole + 1), entry - float(whole));
}

vec4 readColours(int table, float entry) {
    int whole = int(entry);
    return mix(colourAt(table + whole), colourAt(table + whole + 1), entry - float(whole));
}
